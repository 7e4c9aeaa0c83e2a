/* Writes pictures as PPM files: a line of text, then three bytes a pixel, the top row first. */
#ifndef PPM_H
#define PPM_H

#include <stdio.h>

/* `rgba`: four bytes a pixel, of which the last is left out. Gives 0 if the file cannot be written. */
static int write_ppm(const char* path, const unsigned char* rgba, int width, int height) {
  FILE* file = fopen(path, "wb");
  if (!file) return 0;
  fprintf(file, "P6 %d %d 255\n", width, height);
  for (int i = 0; i < width * height; ++i) fwrite(rgba + 4 * i, 1, 3, file);
  return fclose(file) == 0;
}

#endif
