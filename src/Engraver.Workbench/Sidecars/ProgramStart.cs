using System.Globalization;
using System.Text.Json;
using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Sidecars;

/// <summary>The machine position before the first block of a program whose format does not contain it (AGIE): stored in a small file beside the program, for
/// reading it back and linking it.</summary>
/// <param name="Position">Drawing millimetres; null if none is stored for this program.</param>
/// <param name="Message">Why an existing file is not used; otherwise null.</param>
public readonly record struct ProgramStart(Point2D? Position, string? Message)
{
    /// <summary>Suffix appended to the program's file name.</summary>
    public const string FileExtension = ".start.json";

    /// <summary>Saves the start of a program that was just written, unless its format does not need it or it was written to a stream.</summary>
    /// <exception cref="IOException">The path cannot be written.</exception>
    public static void Save(string program, PostForecast? forecast)
    {
        if (forecast is not null) Save(program, forecast.Start);
    }

    /// <param name="start">Drawing millimetres.</param>
    public static void Save(string program, Point2D start)
    {
        if (ContentHash.OfFile(program) is not { } hash) return;
        OutputFile.Write(program + FileExtension, output => output.Write(string.Create(CultureInfo.InvariantCulture, $"{{ \"version\": 1, \"program\": {{\"sha256\": \"{hash}\"}}, \"start\": {{\"x\": {start.X:R}, \"y\": {start.Y:R}}} }}\n")));
    }

    /// <summary>The stored start of the current program file.</summary>
    public static ProgramStart Find(string program)
    {
        ArgumentNullException.ThrowIfNull(program);
        var file = program + FileExtension;
        if (FileKind.IsStream(program) || !File.Exists(file)) return default;
        try
        {
            using var json = JsonDocument.Parse(File.ReadAllText(file));
            var (root, start) = (json.RootElement, json.RootElement.GetProperty("start"));
            var place = new Point2D(start.GetProperty("x").GetDouble(), start.GetProperty("y").GetDouble());
            if (root.GetProperty("version").GetInt32() != 1 || !place.IsFinite) return Ignored("ProgramStart.Unreadable", file);
            return root.GetProperty("program").GetProperty("sha256").GetString() == ContentHash.OfFile(program) ? new ProgramStart(place, null) : Ignored("ProgramStart.OtherProgram", file);
        }
        catch (Exception other) when (other is JsonException or KeyNotFoundException or InvalidOperationException or FormatException or IOException or UnauthorizedAccessException)
        {
            return Ignored("ProgramStart.Unreadable", file);
        }
    }

    private static ProgramStart Ignored(string why, string file) => new(null, Wording.Get(why, file));
}
