# Sourced by scripts with `. usage.sh`: -h and --help as the first word print the comment at the script's top, and nothing
# else is done. Of a script that sets `takes` to the number of words that it can do with, more words and unknown options
# are refused.
case ${1:-} in
  -h | --help)
    awk 'NR > 1 { if (!sub(/^# ?/, "")) exit; print }' "$0"
    exit 0
    ;;
esac
if [ -n "${takes:-}" ]; then
  for word in "$@"; do
    case $word in
      -*)
        echo "error: $(basename "$0"): no option $word; --help shows what would be right" >&2
        exit 2
        ;;
    esac
  done
  if [ $# -gt "$takes" ]; then
    echo "error: $(basename "$0"): $# words, and it takes ${takes}; --help shows what would be right" >&2
    exit 2
  fi
fi
