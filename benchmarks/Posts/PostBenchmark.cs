using System.Runtime.CompilerServices;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Settings;

namespace Engraver.Benchmarks.Posts;

/// <summary>Every target for a set of drawings, posted, read back and certified: lines, bytes, deviation, number of verified programs and of valid
/// certificates, processor time. One row for each target, and a line for each program without a valid certificate.</summary>
internal static class PostBenchmark
{
    /// <summary>Head of the table, Markdown.</summary>
    public static string Head => "| target | programs | not written | lines | bytes | worst deviation mm | verified | certificate stands | post CPU s | verify CPU s |\n|---|---|---|---|---|---|---|---|---|---|";

    /// <summary>All drawings of the folders and all named ones up to the largest size, or a number of them selected from the list by a seed.</summary>
    public static IReadOnlyList<string> Choose(IEnumerable<string> places, int most, long largestBytes, int seed)
    {
        var files = places.SelectMany(place => Directory.Exists(place) ? Directory.EnumerateFiles(place, "*.dxf", SearchOption.AllDirectories) : [place]).Where(file => new FileInfo(file).Length <= largestBytes).Order(StringComparer.Ordinal).ToArray();
        new Random(seed).Shuffle(files);
        return [.. files.Take(most)];
    }

    /// <summary>The rows, each followed by the programs without a valid certificate and by the one with the longest processor time.</summary>
    /// <param name="target">Name of the only target; null: all.</param>
    /// <param name="each">Adds a row for each program before that of its target.</param>
    public static async IAsyncEnumerable<string> RowsAsync(IReadOnlyList<string> files, string? target, bool each, [EnumeratorCancellation] CancellationToken stop)
    {
        foreach (var choice in PostTable.Choices.Where(choice => target is null || choice.Entry.Post.Name == target))
        {
            var all = new PostFigure(choice.Name);
            foreach (var file in files)
            {
                var one = new PostFigure(choice.Name, Path.GetFileName(file));
                await MeasureAsync(one, file, choice, stop).ConfigureAwait(false);
                if (each) yield return one.ToMarkdown();
                all.Add(one);
            }

            yield return all.ToMarkdown();
            foreach (var failure in all.Failures) yield return failure;
            yield return all.Slowest;
        }
    }

    /// <summary>The program is posted, read back for its certificate, and posted again to check the certificate.</summary>
    private static async Task MeasureAsync(PostFigure row, string file, PostChoice choice, CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var settings = new DrawingSettings();
        var drawing = DrawingFile.Open(file, settings, stop);
        var request = new CertificationRequest(drawing, ContentHash.OfFile(file), settings, choice.Entry, TimeProvider.System.GetUtcNow()) { Dialect = choice.Dialect };
        var before = Environment.CpuUsage.TotalTime;
        var posted = PostedProgram.Create(drawing, settings, choice.Entry.Post, request.Options);
        row.AddPosted(posted.Text, (Environment.CpuUsage.TotalTime - before).TotalSeconds);
        if (posted.Text is not { } text || choice.Entry.Reader is null) return;
        before = Environment.CpuUsage.TotalTime;
        var certified = await Certification.CertifyAsync(request with { Program = (file, text) }, progress: null, stop).ConfigureAwait(false);
        var seconds = (Environment.CpuUsage.TotalTime - before).TotalSeconds;
        row.AddCertified(certified.Certificate!, CertificateStatus.Of(certified.Certificate!, Certification.IdentityOf(request)), drawing.HasErrors, seconds);
    }
}
