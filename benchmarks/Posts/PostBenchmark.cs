using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Benchmarks.Posts;

/// <summary>Every target of a set of drawings, posted and read back: lines, bytes, deviation, whether it is verified, processor time. A row for each target, and a line for each program that was not verified.</summary>
internal static class PostBenchmark
{
    /// <summary>Head of the table, Markdown.</summary>
    public static string Head => "| target | programs | not written | lines | bytes | worst deviation mm | verified | post CPU s | verify CPU s |\n|---|---|---|---|---|---|---|---|---|";

    /// <summary>All drawings of the folders that are no larger, or so many of them spread over the list by a seed.</summary>
    public static IReadOnlyList<string> Choose(IEnumerable<string> folders, int most, long largestBytes, int seed)
    {
        var files = folders.SelectMany(folder => Directory.EnumerateFiles(folder, "*.dxf", SearchOption.AllDirectories)).Where(file => new FileInfo(file).Length <= largestBytes).Order(StringComparer.Ordinal).ToArray();
        new Random(seed).Shuffle(files);
        return [.. files.Take(most)];
    }

    /// <summary>The rows, one after the other, each followed by what was not verified and by the program that took most processor time.</summary>
    /// <param name="target">Name of the only target; null: all.</param>
    public static async IAsyncEnumerable<string> RowsAsync(IReadOnlyList<string> files, string? target, [System.Runtime.CompilerServices.EnumeratorCancellation] CancellationToken stop)
    {
        foreach (var entry in PostTable.All.Where(entry => target is null || entry.Post.Name == target))
        {
            IEnumerable<string> dialects = entry.Dialects.Count == 0 ? [""] : entry.Dialects.Keys;
            foreach (var dialect in dialects)
            {
                var row = new PostFigure($"{entry.Post.Name} {dialect}".TrimEnd());
                foreach (var file in files) await MeasureAsync(row, file, entry, dialect, stop).ConfigureAwait(false);
                yield return row.ToMarkdown();
                foreach (var failure in row.Failures) yield return failure;
                yield return row.Slowest;
            }
        }
    }

    private static async Task MeasureAsync(PostFigure row, string file, PostEntry entry, string dialect, CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var settings = new DrawingSettings();
        var drawing = DrawingFile.Open(file, settings, stop);
        var options = dialect.Length == 0 ? PostedProgram.NoOptions : new Dictionary<string, string> { ["dialect"] = dialect };
        var before = Environment.CpuUsage.TotalTime;
        var posted = PostedProgram.Create(drawing, settings, entry.Post, options);
        var between = Environment.CpuUsage.TotalTime;
        row.AddPosted(Path.GetFileName(file), posted.Text, (between - before).TotalSeconds);
        if (posted.Text is not { } text || entry.Reader is not { } usual) return;
        var report = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), dialect.Length == 0 ? usual : entry.Dialects[dialect], drawing, settings, progress: null, stop).ConfigureAwait(false);
        row.AddVerified(Path.GetFileName(file), report, drawing.HasErrors, (Environment.CpuUsage.TotalTime - between).TotalSeconds);
    }
}

/// <summary>What is known of one target.</summary>
internal sealed class PostFigure(string target)
{
    private int _programs;
    private int _unwritten;
    private long _lines;
    private long _bytes;
    private double _worst;
    private int _verified;
    private double _posting;
    private double _verifying;
    private double _longest;

    public List<string> Failures { get; } = [];

    /// <summary>The program that took most processor time to post or to verify; a line.</summary>
    public string Slowest { get; private set; } = "";

    public void AddPosted(string name, string? text, double seconds)
    {
        AddTime(name, "post", seconds);
        _posting += seconds;
        if (text is null) _unwritten++;
        else (_programs, _lines, _bytes) = (_programs + 1, _lines + text.Count(sign => sign == '\n'), _bytes + text.Length);
    }

    public void AddVerified(string name, VerificationReport report, bool isDamaged, double seconds)
    {
        AddTime(name, "verify", seconds);
        _verifying += seconds;
        _worst = Math.Max(_worst, report.MaxDeviationMm ?? 0.0);
        if (report.Ok) _verified++;
        else Failures.Add($"  {target} {name}: {(isDamaged ? "damaged drawing; " : "")}{string.Join(' ', report.Diagnostics.Select(finding => finding.Sentence).Take(1))} extra {report.ExtraLengthMm.ToString("0.####", CultureInfo.InvariantCulture)}");
    }

    private void AddTime(string name, string work, double seconds)
    {
        if (seconds <= _longest) return;
        _longest = seconds;
        Slowest = string.Create(CultureInfo.InvariantCulture, $"  {target}: slowest {work} {name} {seconds:0.##} s");
    }

    public string ToMarkdown() => string.Create(CultureInfo.InvariantCulture, $"| {target} | {_programs} | {_unwritten} | {_lines} | {_bytes} | {_worst:0.#####} | {_verified} | {_posting:0.##} | {_verifying:0.##} |");
}
