// An array of structs.
// top: array_struct_elements
struct Point {
  short x;
  short y;
};
int array_struct_elements(const Point points[16]) {
  int area = 0;
  for (int i = 0; i < 15; ++i) area += points[i].x * points[i + 1].y - points[i + 1].x * points[i].y;
  return area;
}
