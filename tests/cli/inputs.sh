# shellcheck shell=bash
# Small inputs that the tests write themselves, so that nothing but the tool under test has touched them.
# Sourced; `make_inputs FOLDER` writes:
#   cube.obj      a closed cube of side 2 about the origin
#   corner.obj    a floor and a wall that meet, 4 x 4 squares each
#   probe.pfm     8 x 4, latitude-longitude: radiance 1 above the horizon, 1/2 below
#   constant.json, above.json, front.json, right.json    lists of lights

write_cube() {
  cat <<'OBJ'
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 5 6 7 8
f 2 1 4 3
f 6 2 3 7
f 1 5 8 4
f 8 7 3 4
f 1 2 6 5
OBJ
}

write_corner() {
  local i j a
  for j in 0 1 2 3 4; do for i in 0 1 2 3 4; do echo "v $i 0 $j"; done; done
  for j in 0 1 2 3 4; do for i in 0 1 2 3 4; do echo "v $i $j 0"; done; done
  for j in 0 1 2 3; do for i in 0 1 2 3; do
    a=$((j * 5 + i + 1))
    echo "f $a $((a + 5)) $((a + 6)) $((a + 1))"         # up
    a=$((a + 25))
    echo "f $a $((a + 1)) $((a + 6)) $((a + 5))"         # towards +z
  done; done
}

write_probe() {
  local row pixel
  printf 'PF\n8 4\n-1.0\n'                               # little-endian floats, rows from the bottom
  for row in 0 1 2 3; do
    pixel='\x00\x00\x00\x3f'
    [ $row -ge 2 ] && pixel='\x00\x00\x80\x3f'
    for _ in {1..24}; do printf '%b' "$pixel"; done      # eight pixels of three channels
  done
}

make_inputs() {
  mkdir -p "$1"
  write_cube >"$1/cube.obj"
  write_corner >"$1/corner.obj"
  write_probe >"$1/probe.pfm"
  echo '{"lights":[{"type":"constant","radiance":[1,1,1]}]}' >"$1/constant.json"
  # Irradiance pi, so that a white surface facing the light has radiance near 1.
  local type='"type":"directional"' pi='"irradiance":[3.141592653589793,3.141592653589793,3.141592653589793]'
  echo "{\"lights\":[{$type,\"direction\":[0,1,0],$pi}]}" >"$1/above.json"
  echo "{\"lights\":[{$type,\"direction\":[0,0,1],$pi}]}" >"$1/front.json"
  echo "{\"lights\":[{$type,\"direction\":[1,0,0],$pi}]}" >"$1/right.json"
}
