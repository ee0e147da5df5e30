using System.Globalization;
using System.Text;
using System.Text.Json;
using Engraver.Core.Diagnostics;
using Engraver.Core.Posts;
using Engraver.Core.Trajectories.Formats;
using Engraver.Core.Trajectories.Reading;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Verification;

/// <summary>Trajectory files as one text for <see cref="TrajectoryReader"/>: a single file, or all of a folder by its list; either with the places where the machine stands, if the list is beside them.</summary>
public static class TrajectoryReadBack
{
    /// <summary>The reader of a format.</summary>
    public static IProgramReader ReaderOf(TrajectoryFormat format) => new TrajectoryReader(format switch
    {
        TrajectoryFormat.Sace => ControllerLanguage.AbsoluteSpline,
        TrajectoryFormat.XpsSpline => ControllerLanguage.RelativeSpline,
        TrajectoryFormat.XpsLineArc => ControllerLanguage.LineArc,
        _ => ControllerLanguage.Pvt,
    });

    /// <param name="path">A trajectory file, its folder, or the folder's list.</param>
    public static ReadBackFile Open(string path)
    {
        try
        {
            if (Directory.Exists(path)) return All(Path.Combine(path, TrajectoryFolder.ListName));
            if (Path.GetFileName(path) == TrajectoryFolder.ListName) return All(path);
            var list = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(path))!, TrajectoryFolder.ListName);
            var named = File.Exists(list) ? Starts(list).FirstOrDefault(one => one.File == Path.GetFileName(path)) : default;
            return ReadBackFile.FromText(named.File is null ? File.ReadAllText(path) : Marked(named.X, named.Y, File.ReadAllText(path)));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or JsonException or KeyNotFoundException or InvalidOperationException or FormatException)
        {
            return new ReadBackFile(null, [DocumentRules.Unreadable.At(default, unreadable.Message.TrimEnd('.'))]);
        }
    }

    private static ReadBackFile All(string list)
    {
        var text = new StringBuilder();
        foreach (var (file, x, y) in Starts(list)) text.Append(Marked(x, y, File.ReadAllText(Path.Combine(Path.GetDirectoryName(list)!, Path.GetFileName(file)))));
        return ReadBackFile.FromText(text.ToString());
    }

    private static string Marked(double x, double y, string text) => string.Create(CultureInfo.InvariantCulture, $"{TrajectoryReader.Mark}{x:R} {y:R}\n{text.TrimEnd()}\n");

    private static List<(string File, double X, double Y)> Starts(string list)
    {
        using var json = JsonDocument.Parse(File.ReadAllText(list));
        return [.. json.RootElement.GetProperty("trajectories").EnumerateArray().Select(one =>
            (one.GetProperty("file").GetString()!, one.GetProperty("start").GetProperty("x").GetDouble(), one.GetProperty("start").GetProperty("y").GetDouble()))];
    }
}
