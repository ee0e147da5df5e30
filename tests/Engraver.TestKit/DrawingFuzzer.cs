using System.Text;

namespace Engraver.TestKit;

/// <summary>Damages drawings in ways that happen and ways that hardly do: bytes, lines, pairs and whole records. The same seed gives the same file.</summary>
public sealed class DrawingFuzzer(IReadOnlyList<byte[]> originals)
{
    private static readonly string[] OddValues =
    [
        "1e308", "-1e308", "NaN", "1e-320", "99999999999999999999", "-1", "0", "", "12,5", "1.5D3", "32767", "2147483647", "4294967296", "-0", "0x7F", "ENDSEC", "EOF", "INSERT", "BLOCK",
        "\\U+D800", "{\\H1;\\S1^2", "%%999%%", "*Model_Space", "B", "0", "1", "2", "360", "1e-9",
    ];

    private static readonly string[] OddCodes = ["0", "2", "5", "8", "10", "20", "11", "40", "41", "42", "50", "51", "66", "70", "71", "72", "73", "74", "90", "91", "92", "93", "97", "100", "101", "210", "230", "999", "1071", "x", ""];

    /// <summary>The case of a number, and which original it came from.</summary>
    public byte[] Case(int seed)
    {
        var random = new Random(seed);
        var original = originals[random.Next(originals.Count)];
        var isText = original.Length > 0 && original[0] != (byte)'A';
        return isText && random.Next(4) != 0 ? OfPairs(original, random) : OfBytes(original, random);
    }

    private static byte[] OfBytes(byte[] original, Random random)
    {
        var file = original.ToList();
        for (var change = random.Next(1, 8); change > 0 && file.Count > 0; change--)
        {
            var at = random.Next(file.Count);
            switch (random.Next(6))
            {
                case 0:
                    file[at] = (byte)random.Next(256);
                    break;
                case 1:
                    file[at] ^= (byte)(1 << random.Next(8));
                    break;
                case 2:
                    file.Insert(at, (byte)random.Next(256));
                    break;
                case 3:
                    file.RemoveRange(at, Math.Min(random.Next(1, 40), file.Count - at));
                    break;
                case 4:
                    file.InsertRange(at, file.GetRange(at, Math.Min(random.Next(1, 200), file.Count - at)));
                    break;
                default:
                    file.RemoveRange(at, random.Next(4) == 0 ? file.Count - at : 1);
                    break;
            }
        }

        return [.. file];
    }

    private static byte[] OfPairs(byte[] original, Random random)
    {
        var pairs = Encoding.Latin1.GetString(original).Split('\n').Chunk(2).Select(pair => (Code: pair[0], Value: pair.Length > 1 ? pair[1] : "")).ToList();
        for (var change = random.Next(1, 10); change > 0 && pairs.Count > 0; change--)
        {
            var at = random.Next(pairs.Count);
            switch (random.Next(8))
            {
                case 0 or 1:
                    pairs[at] = pairs[at] with { Value = OddValues[random.Next(OddValues.Length)] };
                    break;
                case 2:
                    pairs[at] = pairs[at] with { Code = OddCodes[random.Next(OddCodes.Length)] };
                    break;
                case 3:
                    pairs.RemoveAt(at);
                    break;
                case 4:
                    pairs.Insert(at, pairs[random.Next(pairs.Count)]);
                    break;
                case 5:
                    pairs[at] = pairs[at] with { Value = pairs[random.Next(pairs.Count)].Value };
                    break;
                default:
                    MoveRecord(pairs, at, random);
                    break;
            }
        }

        return Encoding.Latin1.GetBytes(string.Concat(pairs.Select(pair => $"{pair.Code}\n{pair.Value}\n")));
    }

    /// <summary>Cuts a run of pairs out, or copies it, and puts it anywhere.</summary>
    private static void MoveRecord(List<(string Code, string Value)> pairs, int at, Random random)
    {
        var run = pairs.GetRange(at, Math.Min(random.Next(1, 30), pairs.Count - at));
        if (random.Next(2) == 0) pairs.RemoveRange(at, run.Count);
        pairs.InsertRange(random.Next(pairs.Count + 1), run);
    }
}
