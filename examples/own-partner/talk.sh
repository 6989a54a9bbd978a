#!/bin/sh
# A partner for --dialogue exec: (dialogue/speech/external/partner_lines.h): Robot Ada, who has a few words of her own for some turns and says
# the program's own to all others. A line of JSON a turn comes in, and one goes out, within two seconds.

# The value of "NAME": "TEXT" or "NAME": NUMBER in $line, as JSON has it; what the learner wrote cannot pass for one, its quotes are escaped.
text() { printf '%s' "$line" | sed -nE "s/.*[{,]\"$1\":\"(([^\"\\\\]|\\\\.)*)\".*/\\1/p"; }
number() { printf '%s' "$line" | sed -nE "s/.*[{,]\"$1\":([0-9]+).*/\\1/p"; }

praised=0
while IFS= read -r line; do
    ours=$(text ours)
    case $(text kind) in
    praise)
        praised=$((praised + 1))
        said="Beep! $ours That makes $praised."
        ;;
    wrong_meaning) said="Hm, my sensors say no. $ours" ;;
    heard_badly) said="I am only a robot. $ours" ;;
    *) said=$ours ;;
    esac
    printf '{"turn":%s,"text":"%s"}\n' "$(number turn)" "$said"
done
