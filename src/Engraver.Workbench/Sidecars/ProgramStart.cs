using System.Globalization;
using System.Text.Json;
using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Sidecars;

/// <summary>Where the machine stands before the first block of a program whose form does not say it (AGIE): kept in a small file beside the program, for
/// whoever reads it back or links it.</summary>
/// <param name="Place">Drawing millimetres; null where none is kept for this program.</param>
/// <param name="Sentence">Why a file that is there is not used; null for none.</param>
public readonly record struct ProgramStart(Point2D? Place, string? Sentence)
{
    /// <summary>Added to the whole name of the program.</summary>
    public const string Ending = ".start.json";

    /// <summary>Keeps the start of a program that was just written to a file; of a form that needs none, and of a stream, nothing is kept.</summary>
    /// <exception cref="IOException">The place cannot be written.</exception>
    public static void Keep(string program, PostForecast? forecast)
    {
        if (forecast is not null) Keep(program, forecast.Start);
    }

    /// <param name="start">Drawing millimetres.</param>
    public static void Keep(string program, Point2D start)
    {
        if (ContentHash.OfFile(program) is not { } hash) return;
        OutputFile.Write(program + Ending, output => output.Write(string.Create(CultureInfo.InvariantCulture, $"{{ \"version\": 1, \"program\": {{\"sha256\": \"{hash}\"}}, \"start\": {{\"x\": {start.X:R}, \"y\": {start.Y:R}}} }}\n")));
    }

    /// <summary>The start that is kept for the program as it is now.</summary>
    public static ProgramStart Find(string program)
    {
        ArgumentNullException.ThrowIfNull(program);
        var file = program + Ending;
        if (FileKind.IsStream(program) || !File.Exists(file)) return default;
        try
        {
            using var json = JsonDocument.Parse(File.ReadAllText(file));
            var (root, start) = (json.RootElement, json.RootElement.GetProperty("start"));
            var place = new Point2D(start.GetProperty("x").GetDouble(), start.GetProperty("y").GetDouble());
            if (root.GetProperty("version").GetInt32() != 1 || !place.IsFinite) return Unused("ProgramStart.Unreadable", file);
            return root.GetProperty("program").GetProperty("sha256").GetString() == ContentHash.OfFile(program) ? new ProgramStart(place, null) : Unused("ProgramStart.OtherProgram", file);
        }
        catch (Exception other) when (other is JsonException or KeyNotFoundException or InvalidOperationException or FormatException or IOException or UnauthorizedAccessException)
        {
            return Unused("ProgramStart.Unreadable", file);
        }
    }

    private static ProgramStart Unused(string why, string file) => new(null, Wording.Get(why, file));
}
