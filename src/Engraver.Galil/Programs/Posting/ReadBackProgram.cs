using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Diagnostics;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Posting;

/// <summary>A posted file taken apart into the programs that are to be loaded and run one after the other (docs of <c>engraver post</c>: comment lines <c>'CHUNK 2 OF 3</c>).</summary>
/// <param name="Chunks">In order; not to be run when there are diagnostics.</param>
/// <param name="Diagnostics">Why the file cannot be run.</param>
public sealed partial record ReadBackProgram(IReadOnlyList<ReadBackChunk> Chunks, IReadOnlyList<Diagnostic> Diagnostics)
{
    private const string Entry = "#JOB";

    /// <summary>Any text: what is no program gives diagnostics.</summary>
    public static ReadBackProgram Parse(string text)
    {
        var lines = text.ReplaceLineEndings("\n").TrimEnd('\n', ' ').Split('\n');
        if (lines.All(string.IsNullOrWhiteSpace)) return new ReadBackProgram([], [VerificationRules.ProgramEmpty.At(default)]);
        var findings = new List<Diagnostic>();
        CheckChunkMarks(lines, findings);
        CheckLines(lines, findings);
        var chunks = Split(lines);
        findings.AddRange(chunks.Where(chunk => !chunk.Lines.Any(IsEntry)).Select(chunk => VerificationRules.NoJobLabel.At(new SourceRef(chunk.FirstLine))));
        return new ReadBackProgram(chunks, findings);
    }

    private static bool IsEntry(string line) => line.Split(';')[0].Trim() == Entry;

    private static List<ReadBackChunk> Split(string[] lines)
    {
        var starts = Enumerable.Range(0, lines.Length).Where(i => i == 0 || ChunkMark().IsMatch(lines[i])).ToList();
        return [.. starts.Select((start, i) => new ReadBackChunk(start + 1, lines[start..(i + 1 < starts.Count ? starts[i + 1] : lines.Length)]))];
    }

    /// <summary>Marks count up from 1 to the number they name, the first one before everything else.</summary>
    private static void CheckChunkMarks(string[] lines, List<Diagnostic> findings)
    {
        var marks = Enumerable.Range(0, lines.Length).Where(i => ChunkMark().IsMatch(lines[i])).ToList();
        if (marks.Count == 0) return;
        var count = ChunkMark().Match(lines[marks[0]]).Groups["count"].Value;
        for (var i = 0; i < marks.Count; i++)
        {
            var wanted = (i + 1).ToString(CultureInfo.InvariantCulture);
            var mark = ChunkMark().Match(lines[marks[i]]);
            if (mark.Groups["number"].Value == wanted && mark.Groups["count"].Value == count && (i > 0 || marks[0] == 0)) continue;
            findings.Add(VerificationRules.ChunksIncomplete.At(new SourceRef(marks[i] + 1), wanted, count, lines[marks[i]]));
            return;
        }

        if (marks.Count.ToString(CultureInfo.InvariantCulture) != count)
            findings.Add(VerificationRules.ChunksIncomplete.At(new SourceRef(lines.Length), (marks.Count + 1).ToString(CultureInfo.InvariantCulture), count, Wording.Get("ReadBackProgram.EndFile")));
    }

    private static void CheckLines(string[] lines, List<Diagnostic> findings)
    {
        for (var i = 0; i < lines.Length && findings.Count == 0; i++)
        {
            var reason = lines[i].Length > DmcLimits.LineLength ? Wording.Get("ReadBackProgram.HasCharactersAllowed", lines[i].Length, DmcLimits.LineLength)
                : lines[i].AsSpan().ContainsAny("\\\x04\x11\x1A") ? Wording.Get("ReadBackProgram.HoldsCharacterEndsDownload")
                : null;
            if (reason is not null) findings.Add(VerificationRules.LineUnusable.At(new SourceRef(i + 1), reason));
        }
    }

    [GeneratedRegex(@"^'CHUNK (?<number>[0-9]{1,9}) OF (?<count>[0-9]{1,9})\s*$", RegexOptions.CultureInvariant)]
    private static partial Regex ChunkMark();
}

/// <summary>One program of a posted file.</summary>
/// <param name="FirstLine">Its first line in the file, from 1.</param>
/// <param name="Lines">At least one.</param>
public sealed record ReadBackChunk(int FirstLine, IReadOnlyList<string> Lines)
{
    public string Text => string.Join('\n', Lines) + "\n";
}
