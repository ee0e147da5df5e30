using System.Text;
using Engraver.Core.Trajectories.Reading;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Composition;

/// <summary>Detects the format of a program file from its first characters, otherwise from its extension.</summary>
public static class ProgramFormatDetector
{
    /// <summary>Number of characters that are examined.</summary>
    private const int HeadLength = 4096;

    /// <summary>The entry whose reader accepts the file, and its dialect if the file names one.</summary>
    /// <returns>Null if neither is recognised.</returns>
    public static PostChoice? Of(string path)
    {
        ArgumentNullException.ThrowIfNull(path);
        var name = Named(ReadHead(path)) ?? ByExtension(path);
        return name is null ? null : PostTable.Choices.First(choice => choice.Entry.Post.Name == name.Value.Target && choice.Dialect == name.Value.Dialect);
    }

    private static (string Target, string? Dialect)? ByExtension(string path) =>
        PostTable.All.FirstOrDefault(entry => entry.Reader is not null && path.EndsWith(entry.Post.FileExtension, StringComparison.OrdinalIgnoreCase)) is { } entry ? (entry.Post.Name, null) : null;

    /// <summary>The start of the file; empty if it cannot be read (its reader reports that), and for a stream, because a pipe can be read only once.</summary>
    private static string ReadHead(string path)
    {
        try
        {
            if (FileKind.IsStream(path)) return "";
            using var text = new StreamReader(path);
            var read = new char[HeadLength];
            return new string(read, 0, text.ReadBlock(read, 0, HeadLength));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or DecoderFallbackException)
        {
            return "";
        }
    }

    private static (string Target, string? Dialect)? Named(string text)
    {
        var rows = text.Split('\n', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
        if (rows.Length == 0) return null;
        if (rows[0].StartsWith(TrajectoryReader.Mark, StringComparison.Ordinal)) return rows.Length > 1 ? Trajectory(rows[1]) : null;
        if (rows is ["0", "SECTION", ..]) return ("cldata", null);
        if (rows.Any(row => row is "#JOB") || rows[0].StartsWith("'CHUNK ", StringComparison.Ordinal)) return ("galil", null);
        if (text.Contains("\t001\t0", StringComparison.Ordinal) && rows[0][0] == '%') return ("agie", null);
        if (rows[0].StartsWith("IN;", StringComparison.Ordinal) || rows[0] == "IN") return ("hpgl", null);
        return rows[0] == "%" || rows.Any(IsGcode) ? ("gcode", rows.Take(2).Any(row => row[0] == '(' && row.Contains("grbl", StringComparison.Ordinal)) ? "grbl" : null) : null;
    }

    private static (string Target, string? Dialect)? Trajectory(string row) => row.Split('=')[0].Trim() switch
    {
        "FirstTangent" or "DiscontinuityAngle" or "Line" or "Arc" => ("xps-linearc", null),
        _ when row.Count(sign => sign == ',') == 4 => ("xps-pvt", null),
        _ when row.Count(sign => sign == ',') == 2 => ("xps-spline", null),
        _ => null,
    };

    private static bool IsGcode(string row) => row.Length > 1 && char.ToUpperInvariant(row[0]) is 'G' or 'M' or 'N' && char.IsAsciiDigit(row[1]);
}
