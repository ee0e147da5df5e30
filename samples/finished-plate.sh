#!/usr/bin/env bash
# Finished plates on the simulated controller, from one drawing and one file of operations: the plan, a picture, one plate that stops at each change of the tool
# and is resumed, and a series of plates. It ends with exit code 1 if a plate is not complete.
# Usage: samples/finished-plate.sh [FOLDER [PLATES]]; FOLDER (artifacts/finished-plate) gets the picture, the journals and the counters.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=${1:-artifacts/finished-plate}
plates=${2:-5}
engraver=${ENGRAVER:-./engraver}
rm -rf "$folder"
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
export XDG_DATA_HOME=$folder XDG_CONFIG_HOME=$folder XDG_STATE_HOME=$folder
drawing=samples/finished-plate.dxf
job=(--cut text --operations samples/finished-plate.operations.json --machine samples/machine-mill.json)

echo "== What is cut, with which tools"
"$engraver" plan "$drawing" "${job[@]}"

echo "== The path of the tools: $folder/plate.svg"
"$engraver" plot "$drawing" "${job[@]}" -o "$folder/plate.svg"

echo "== One plate that ends at each change of the tool and is resumed"
"$engraver" run "$drawing" "${job[@]}" --connect sim: --quiet --tool-change stop --journal "$folder/section-1.jsonl"
"$engraver" run "$drawing" "${job[@]}" --connect sim: --quiet --tool-change stop --journal "$folder/section-2.jsonl" --resume "$folder/section-1.jsonl"
"$engraver" run "$drawing" "${job[@]}" --connect sim: --quiet --tool-change stop --journal "$folder/section-3.jsonl" --resume "$folder/section-2.jsonl"
grep -q '"outcome": *"complete"' "$folder/section-3.jsonl"

echo "== A series of $plates; Enter confirms each change of the tool and each blank"
yes '' | "$engraver" run "$drawing" "${job[@]}" --connect sim: --quiet --copies "$plates" --tool-change ask
