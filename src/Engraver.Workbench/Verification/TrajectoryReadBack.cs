using System.Globalization;
using System.Text.Json;
using Engraver.Core.Languages;
using Engraver.Core.Posts;
using Engraver.Core.Trajectories.Formats;
using Engraver.Core.Trajectories.Reading;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Verification;

/// <summary>Trajectory files as one text for <see cref="TrajectoryReader"/>: a single file, or all of a folder by its list; both with the start positions if
/// the list is available.</summary>
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
    public static ReadBackFile Open(string path) => new(() => Text(path));

    private static TextReader Text(string path)
    {
        if (Directory.Exists(path)) return All(Path.Combine(path, TrajectoryFolder.ListName));
        if (Path.GetFileName(path) == TrajectoryFolder.ListName) return All(path);
        var list = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(path))!, TrajectoryFolder.ListName);
        var named = File.Exists(list) ? Starts(list).FirstOrDefault(one => one.File == Path.GetFileName(path)) : default;
        return named.File is null ? new StreamReader(path) : new JoinedText(Marked(named.X, named.Y, path));
    }

    private static JoinedText All(string list) => new(Starts(list).SelectMany(one => Marked(one.X, one.Y, Path.Combine(Path.GetDirectoryName(list)!, Path.GetFileName(one.File)))));

    /// <summary>The start position, then the file, opened on demand.</summary>
    private static IEnumerable<TextReader> Marked(double x, double y, string path)
    {
        yield return new StringReader(string.Create(CultureInfo.InvariantCulture, $"{TrajectoryReader.Mark}{x:R} {y:R}\n"));
        yield return new StreamReader(path);
        yield return new StringReader("\n");
    }

    /// <exception cref="InvalidDataException">It is not such a list.</exception>
    private static List<(string File, double X, double Y)> Starts(string list)
    {
        try
        {
            using var json = JsonDocument.Parse(File.ReadAllText(list));
            return [.. json.RootElement.GetProperty("trajectories").EnumerateArray().Select(one =>
                (one.GetProperty("file").GetString()!, one.GetProperty("start").GetProperty("x").GetDouble(), one.GetProperty("start").GetProperty("y").GetDouble()))];
        }
        catch (Exception other) when (other is JsonException or KeyNotFoundException or InvalidOperationException or FormatException)
        {
            throw new InvalidDataException(SystemErrorText.FromException(other), other);
        }
    }

    /// <summary>Concatenated texts; each is opened at the end of the previous one.</summary>
    private sealed class JoinedText(IEnumerable<TextReader> parts) : TextReader
    {
        private readonly IEnumerator<TextReader> _parts = parts.GetEnumerator();
        private TextReader? _part;

        public override int Peek() => IsAtText() ? _part!.Peek() : -1;

        public override int Read() => IsAtText() ? _part!.Read() : -1;

        public override int Read(char[] buffer, int index, int count) => IsAtText() ? _part!.Read(buffer, index, count) : 0;

        protected override void Dispose(bool disposing)
        {
            if (disposing) _part?.Dispose();
            if (disposing) _parts.Dispose();
            base.Dispose(disposing);
        }

        private bool IsAtText()
        {
            while (_part is null || _part.Peek() < 0)
            {
                _part?.Dispose();
                if (!_parts.MoveNext()) return false;
                _part = _parts.Current;
            }

            return true;
        }
    }
}
