using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Posts;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Divides a posted file, while it is read, into the programs that are to be downloaded and run one after the other (help of <c>engraver post</c>:
/// comment lines <c>'CHUNK 2 OF 3</c>). Only one program is in memory at a time.</summary>
/// <remarks>Marks count from 1 to the number that they name; the first one is at the start of the file.</remarks>
public sealed partial class ReadBackProgram(TextReader text)
{
    private const string Entry = "#JOB";

    /// <summary>Maximum number of stored lines of a program. A controller holds half as many, so that a longer program is rejected in any case.</summary>
    private const int MaxLines = 2 * DmcLimits.ProgramLines;

    private readonly ProgramRows _lines = new(text);
    private string? _chunkLines;
    private string _count = "";
    private int _marks;
    private bool _hasAny;

    /// <summary>Number of programs in the file according to its marks; 1 without marks.</summary>
    public int Count => int.TryParse(_count, NumberStyles.None, CultureInfo.InvariantCulture, out var count) ? Math.Max(1, count) : 1;

    /// <summary>Takes the next program from the text, with any content.</summary>
    /// <returns>No chunk after the last one, or if the rest of the file cannot be run; then the fault states the reason.</returns>
    public (ReadBackChunk? Chunk, Diagnostic? Fault) Next()
    {
        var (lines, first, full) = (new List<string>(), 0, 0);
        for (var row = _chunkLines ?? _lines.Next(); row is not null; row = _lines.Next())
        {
            if (_chunkLines is null && ChunkMark().Match(row) is { Success: true } mark)
            {
                if (Misplaced(mark, row) is { } misplaced) return (null, misplaced);
                if (first > 0)
                {
                    _chunkLines = row;
                    return Whole(first, lines);
                }
            }

            if (Unusable(row) is { } unusable) return (null, unusable);
            _chunkLines = null;
            if (first == 0) first = _lines.Number;
            if (lines.Count < MaxLines) lines.Add(row);
            if (!string.IsNullOrWhiteSpace(row)) full = _lines.Number - first + 1;
        }

        return Last(first, lines, full);
    }

    /// <summary>Blank lines and blanks at the end of the file are ignored.</summary>
    /// <param name="full">Number of the last line that is not blank, from 1; 0 for none.</param>
    private (ReadBackChunk? Chunk, Diagnostic? Fault) Last(int first, List<string> lines, int full)
    {
        if (full == 0) return (null, _hasAny ? null : VerificationRules.ProgramEmpty.At(default));
        if (_marks > 0 && NumberText.Whole(_marks) != _count) return (null, VerificationRules.ChunksIncomplete.At(new SourceRef(first + full - 1), NumberText.Whole(_marks + 1), _count, Wording.Get("ReadBackProgram.EndOfFile")));
        if (full < lines.Count) lines.RemoveRange(full, lines.Count - full);
        lines[^1] = lines[^1].TrimEnd(' ');
        return Whole(first, lines);
    }

    private (ReadBackChunk? Chunk, Diagnostic? Fault) Whole(int first, List<string> lines)
    {
        _hasAny = true;
        return lines.Exists(IsEntry) ? (new ReadBackChunk(first, lines), null) : (null, VerificationRules.NoJobLabel.At(new SourceRef(first)));
    }

    private Diagnostic? Misplaced(Match mark, string row)
    {
        var (isFirst, wanted) = (_marks == 0, NumberText.Whole(++_marks));
        if (isFirst) _count = mark.Groups["count"].Value;
        var isRight = mark.Groups["number"].Value == wanted && mark.Groups["count"].Value == _count && (!isFirst || _lines.Number == 1);
        return isRight ? null : VerificationRules.ChunksIncomplete.At(new SourceRef(_lines.Number), wanted, _count, row);
    }

    private Diagnostic? Unusable(string row)
    {
        var reason = row.Length > DmcLimits.LineLength ? Wording.Get("ReadBackProgram.LineTooLong", row.Length, DmcLimits.LineLength)
            : row.AsSpan().ContainsAny("\\\x04\x11\x1A") ? Wording.Get("ReadBackProgram.EndsDownload")
            : null;
        return reason is null ? null : VerificationRules.LineUnusable.At(new SourceRef(_lines.Number), reason);
    }

    private static bool IsEntry(string line) => line.Split(';')[0].Trim() == Entry;

    [GeneratedRegex(@"^'CHUNK (?<number>[0-9]{1,9}) OF (?<count>[0-9]{1,9})\s*$", RegexOptions.CultureInvariant)]
    private static partial Regex ChunkMark();
}
