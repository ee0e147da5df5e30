using System.Text;
using Engraver.Tools.CrossChecks;

namespace Engraver.Tools.Minimising;

/// <summary>Shrinks a drawing that shows a fault: first whole records, then pairs, then single lines, then values. The result is small enough to be read by
/// a person.</summary>
public static class DrawingMinimiser
{
    /// <summary>Maximum number of trials: enough for a drawing of some thousand records; a fault in one record takes some hundred.</summary>
    public const int MaxTrials = 20_000;

    private static readonly string[] SimplerValues = ["", "0", "1", "A"];

    /// <summary>A small file that still shows the fault; the file itself if nothing could be removed.</summary>
    /// <param name="file">A file for which <paramref name="shows"/> is true. A binary DXF becomes text if the fault remains.</param>
    /// <param name="shows">Whether a file shows the fault; must be deterministic.</param>
    /// <param name="cancellation">Cancels the search with an <see cref="OperationCanceledException"/>.</param>
    public static byte[] Minimise(byte[] file, Predicate<byte[]> shows, CancellationToken cancellation)
    {
        var reduction = new Reduction(MaxTrials, cancellation);
        if (AsText(file) is { } text && reduction.Try(() => shows(text))) file = text;
        else if (IsBinary(file)) return OfBlocks(file, shows, reduction);
        var lines = Lines(file);
        lines = [.. reduction.Reduce(Records(lines), kept => shows(Bytes(kept.SelectMany(record => record)))).SelectMany(record => record)];
        lines = [.. reduction.Reduce(Pairs(lines), kept => shows(Bytes(kept.SelectMany(pair => pair)))).SelectMany(pair => pair)];
        lines = reduction.Reduce(lines, kept => shows(Bytes(kept)));
        Simplify(lines, shows, reduction);
        return Bytes(lines);
    }

    private static bool IsBinary(byte[] file) => file.AsSpan().StartsWith("AutoCAD Binary DXF"u8);

    private static byte[]? AsText(byte[] file)
    {
        if (!IsBinary(file)) return null;
        var binary = new CrossCheckFile(file);
        return Encoding.Latin1.GetBytes(string.Concat(binary.Tags.Select(tag => $"{tag.Code}\n{binary.Line(tag)}\n")));
    }

    /// <summary>Shrinks a file whose fault is in its binary form, by removing runs of bytes.</summary>
    private static byte[] OfBlocks(byte[] file, Predicate<byte[]> shows, Reduction reduction) =>
        [.. reduction.Reduce(file.ToList(), kept => shows([.. kept]))];

    private static List<string> Lines(byte[] file)
    {
        var (lines, text, start) = (new List<string>(), Encoding.Latin1.GetString(file), 0);
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] != '\n' && (text[i] != '\r' || (i + 1 < text.Length && text[i + 1] is '\n' or '\r'))) continue;
            lines.Add(text[start..(i + 1)]);
            start = i + 1;
        }

        if (start < text.Length) lines.Add(text[start..]);
        return lines;
    }

    private static byte[] Bytes(IEnumerable<string> lines) => Encoding.Latin1.GetBytes(string.Concat(lines));

    private static List<string[]> Pairs(List<string> lines) => [.. lines.Chunk(2)];

    /// <summary>The lines divided into records, each from one group code 0 to the next.</summary>
    private static List<List<string>> Records(List<string> lines)
    {
        var records = new List<List<string>>();
        foreach (var pair in lines.Chunk(2))
        {
            if (records.Count == 0 || pair[0].Trim() == "0") records.Add([]);
            records[^1].AddRange(pair);
        }

        return records;
    }

    private static void Simplify(List<string> lines, Predicate<byte[]> shows, Reduction reduction)
    {
        for (var i = 1; i < lines.Count && !reduction.IsExhausted; i += 2)
        {
            var (original, end) = (lines[i], lines[i][lines[i].TrimEnd('\r', '\n').Length..]);
            foreach (var simpler in SimplerValues.Where(value => value.Length < original.Length - end.Length))
            {
                lines[i] = simpler + end;
                if (reduction.Try(() => shows(Bytes(lines)))) break;
                lines[i] = original;
            }
        }
    }
}
