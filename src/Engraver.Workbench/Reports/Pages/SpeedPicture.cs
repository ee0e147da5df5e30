using System.Text;
using System.Xml.Linq;
using Engraver.Core;
using Engraver.Workbench.Playback;

namespace Engraver.Workbench.Reports.Pages;

/// <summary>The planned speed over time as SVG for printing: cuts filled, rapids dashed.</summary>
internal static class SpeedPicture
{
    /// <summary>Maximum number of samples of a long job.</summary>
    private const int MaxSamples = 2400;
    private const double Width = 1000.0;
    private const double Height = 260.0;
    private const double Left = 62.0;
    private const double Right = 18.0;
    private const double Top = 16.0;
    private const double Bottom = 38.0;
    private const double SecondsPerMinute = 60.0;

    private static readonly XNamespace s_svg = "http://www.w3.org/2000/svg";

    /// <summary>Sizes of steps between two lines of the grid, times a power of ten.</summary>
    private static readonly double[] s_steps = [1.0, 2.0, 2.5, 5.0, 10.0];

    public static void Write(PlannedMotion motion, TextWriter output)
    {
        var samples = SpeedPlot.Sample(motion, MaxSamples);
        var (duration, peak) = (Math.Max(motion.DurationSeconds, 1e-9), Math.Max(samples.Select(sample => sample.Speed * SecondsPerMinute).DefaultIfEmpty().Max(), 1e-9));
        double X(double seconds) => Left + (seconds / duration * (Width - Left - Right));
        double Y(double speed) => Height - Bottom - (speed / peak * (Height - Top - Bottom));
        var picture = new XElement(s_svg + "svg", new XAttribute("viewBox", $"0 0 {NumberText.Rounded(Width, 2)} {NumberText.Rounded(Height, 2)}"), new XAttribute("width", Width), new XAttribute("height", Height));
        foreach (var seconds in Grid(duration)) picture.Add(Line($"M{Pair(X(seconds), Top)}V{NumberText.Rounded(Height - Bottom, 2)}"), Label(X(seconds), Height - Bottom + 16.0, "middle", NumberText.Rounded(seconds, 2)));
        foreach (var speed in Grid(peak)) picture.Add(Line($"M{Pair(Left, Y(speed))}H{NumberText.Rounded(Width - Right, 2)}"), Label(Left - 6.0, Y(speed) + 4.0, "end", NumberText.Rounded(speed, 2)));
        foreach (var (cutting, path) in Runs(samples, X, Y)) picture.Add(Path(cutting ? "cutting" : "moving", path));
        picture.Add(Label(Width - Right, Height - 6.0, "end", Wording.Get("JobReport.SpeedAxes")));
        output.Write(picture.ToString(SaveOptions.DisableFormatting));
    }

    /// <summary>Neighbouring samples of one kind as one path; the path of a cut is closed to the axis at both ends.</summary>
    private static IEnumerable<(bool Cutting, string Path)> Runs(IReadOnlyList<SpeedSample> samples, Func<double, double> x, Func<double, double> y)
    {
        for (var first = 0; first < samples.Count;)
        {
            var (last, cutting) = (first, samples[first].Cutting);
            while (last + 1 < samples.Count && samples[last + 1].Cutting == cutting) last++;
            var path = new StringBuilder();
            if (cutting) path.Append('M').Append(Pair(x(samples[first].Seconds), y(0.0)));
            for (var i = first; i <= last; i++) path.Append(path.Length == 0 ? 'M' : 'L').Append(Pair(x(samples[i].Seconds), y(samples[i].Speed * SecondsPerMinute)));
            if (cutting) path.Append('L').Append(Pair(x(samples[last].Seconds), y(0.0))).Append('Z');
            yield return (cutting, path.ToString());
            first = last + 1;
        }
    }

    /// <summary>Five to ten round values from 0 to the maximum.</summary>
    private static IEnumerable<double> Grid(double max)
    {
        const double Lines = 5.0;
        var tens = Math.Pow(10.0, Math.Floor(Math.Log10(max / Lines)));
        var step = s_steps.Select(size => size * tens).Last(size => size * Lines <= max);
        for (var i = 0; i * step <= max; i++) yield return i * step;
    }

    private static XElement Line(string path) => Path("grid", path);

    private static XElement Path(string style, string path) => new(s_svg + "path", new XAttribute("class", style), new XAttribute("d", path));

    private static XElement Label(double x, double y, string anchor, string text) => new(s_svg + "text", new XAttribute("x", NumberText.Rounded(x, 2)), new XAttribute("y", NumberText.Rounded(y, 2)), new XAttribute("text-anchor", anchor), text);

    private static string Pair(double x, double y) => $"{NumberText.Rounded(x, 2)},{NumberText.Rounded(y, 2)}";
}
