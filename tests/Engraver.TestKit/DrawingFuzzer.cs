using System.Globalization;
using System.Text;

namespace Engraver.TestKit;

/// <summary>Damages drawings in frequent and rare ways: bytes, lines, pairs and whole records, weights, knots and numbers, and sectors of zeros. The same seed
/// gives the same file.</summary>
public sealed class DrawingFuzzer(IReadOnlyList<byte[]> originals)
{
    private static readonly string[] OddValues =
    [
        "1e308", "-1e308", "1e99", "-1e95", "1e70", "NaN", "1e-320", "99999999999999999999", "-1", "0", "", "12,5", "1.5D3", "32767", "2147483647", "4294967296", "-0", "0x7F", "ENDSEC", "EOF", "INSERT", "BLOCK",
        "\\U+D800", "{\\H1;\\S1^2", "%%999%%", "*Model_Space", "B", "0", "1", "2", "360", "1e-9",
    ];

    private static readonly string[] OddCodes = ["0", "2", "5", "8", "10", "20", "11", "40", "41", "42", "50", "51", "66", "70", "71", "72", "73", "74", "90", "91", "92", "93", "97", "100", "101", "210", "230", "999", "1071", "x", ""];

    /// <summary>The case of a number, and the original that it was made from.</summary>
    public byte[] Case(int seed)
    {
        var random = new Random(seed);
        var original = originals[random.Next(originals.Count)];
        var isText = original.Length > 0 && original[0] != (byte)'A';
        var file = random.Next(8) switch
        {
            < 2 => OfBytes(original, random),
            < 5 when isText => OfPairs(original, random),
            < 7 when isText => OfMeaning(original, random),
            _ => OfBytes(original, random),
        };
        if (random.Next(12) == 0) ZeroSector(file, random);
        return file;
    }

    /// <summary>A part of the file that was never written: a sector of zeros, or a few zero bytes.</summary>
    private static void ZeroSector(byte[] file, Random random)
    {
        var size = 1 << random.Next(13);
        var at = size * random.Next((file.Length / size) + 1);
        file.AsSpan(Math.Min(at, file.Length), Math.Min(size, file.Length - Math.Min(at, file.Length))).Clear();
    }

    /// <summary>Changes significant parts: weights, knots, digits of numbers, and the lines that divide the file into records and sections.</summary>
    private static byte[] OfMeaning(byte[] original, Random random)
    {
        var pairs = Pairs(original);
        for (var change = random.Next(1, 6); change > 0 && pairs.Count > 0; change--)
        {
            var kind = random.Next(5);
            int[] at = [.. Enumerable.Range(0, pairs.Count).Where(i => IsOf(kind, pairs[i]))];
            if (at.Length == 0) continue;
            var chosen = at[random.Next(at.Length)];
            if (kind == 3 && random.Next(3) == 0) pairs.RemoveAt(chosen);
            else pairs[chosen] = Changed(kind, pairs[chosen], random);
        }

        return Bytes(pairs);
    }

    /// <summary>0 weights and scales, 1 knots, 2 any number, 3 starts of records, 4 names of sections and blocks.</summary>
    private static bool IsOf(int kind, (string Code, string Value) pair) => (kind, pair.Code.Trim()) switch
    {
        (0, "41" or "42" or "43") or (1, "40") or (3, "0") or (4, "2") => true,
        (2, var code) => code.Length == 2 && double.TryParse(pair.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out _),
        _ => false,
    };

    private static (string Code, string Value) Changed(int kind, (string Code, string Value) pair, Random random)
    {
        if (kind == 3) return random.Next(2) == 0 ? pair with { Code = OddCodes[random.Next(OddCodes.Length)] } : pair with { Value = Misspelt(pair.Value, random) };
        if (kind is 2 or 4) return pair with { Value = Misspelt(pair.Value, random) };
        var power = Math.Pow(10.0, random.Next(-20, 21));
        return pair with { Value = (power * (random.Next(3) == 0 ? random.NextDouble() : 1.0)).ToString("R", CultureInfo.InvariantCulture) };
    }

    private static string Misspelt(string value, Random random)
    {
        const string Letters = "0123456789.-+eE5O \0";
        if (value.Length == 0) return "5";
        var at = random.Next(value.Length);
        return value[..at] + Letters[random.Next(Letters.Length)] + value[(at + random.Next(2))..];
    }

    private static List<(string Code, string Value)> Pairs(byte[] file) =>
        [.. Encoding.Latin1.GetString(file).Split('\n').Chunk(2).Select(pair => (Code: pair[0], Value: pair.Length > 1 ? pair[1] : ""))];

    private static byte[] Bytes(List<(string Code, string Value)> pairs) => Encoding.Latin1.GetBytes(string.Concat(pairs.Select(pair => $"{pair.Code}\n{pair.Value}\n")));

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
        var pairs = Pairs(original);
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

        return Bytes(pairs);
    }

    /// <summary>Cuts or copies a run of pairs, and inserts it anywhere.</summary>
    private static void MoveRecord(List<(string Code, string Value)> pairs, int at, Random random)
    {
        var run = pairs.GetRange(at, Math.Min(random.Next(1, 30), pairs.Count - at));
        if (random.Next(2) == 0) pairs.RemoveRange(at, run.Count);
        pairs.InsertRange(random.Next(pairs.Count + 1), run);
    }
}
