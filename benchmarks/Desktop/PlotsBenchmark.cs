using System.Diagnostics;
using System.Globalization;
using Avalonia;
using Avalonia.VisualTree;
using Engraver.App.Plots;
using Engraver.App.Sessions;
using Engraver.App.Shell;
using Engraver.SoftwarePlatform.Headless;

namespace Engraver.Benchmarks.Desktop;

/// <summary>Measures the Plots page of a large drawing in a window in memory: the first picture, frames while the axis is panned and zoomed, frames in which
/// only the position of the playback moves, and memory.</summary>
internal sealed class PlotsBenchmark(DesktopSession session, ShellWindow window, HeadlessDesktop desktop, TextWriter output)
{
    private const int Frames = 200;
    private const double Zoom = 0.8;
    private static readonly TimeSpan s_timeout = TimeSpan.FromMinutes(10);

    /// <param name="drawing">Path of the drawing.</param>
    public void Run(string drawing)
    {
        Await(session.Desk.Queue.RunAsync("OPEN", drawing));
        Await(session.Desk.SettleAsync());
        var before = GC.GetTotalMemory(forceFullCollection: true);
        var watch = Stopwatch.StartNew();
        window.Palettes.Show("Plots");
        desktop.Step();
        var plot = window.GetVisualDescendants().OfType<PlotSurface>().Single();
        desktop.StepUntil(() => plot.Content.Plan is not null, s_timeout);
        desktop.Step();
        Report($"{plot.Content.Plan!.Count:N0} samples, first picture: {watch.Elapsed.TotalMilliseconds:0} ms, memory: {(GC.GetTotalMemory(forceFullCollection: true) - before) / 1e6:0} MB");
        output.WriteLine("| Frame | frames | p50 ms | p99 ms | worst ms |");
        output.WriteLine("|---|---:|---:|---:|---:|");
        var whole = plot.Content.End;
        foreach (var part in new[] { 1.0, 0.5, 0.01 })
        {
            var span = whole * part * (part < 1.0 ? 1.0 : Zoom);
            Measure(FormattableString.Invariant($"pan, {part * (part < 1.0 ? 1.0 : Zoom):P0} visible"), frame => plot.Show((whole - span) * frame / Frames, ((whole - span) * frame / Frames) + span));
        }

        Measure("position of the playback", frame => session.Desk.Derived.MoveTo(session.Desk.Derived.TotalSeconds * frame / Frames));
    }

    private void Measure(string what, Action<int> change)
    {
        var times = Enumerable.Range(0, Frames).Select(frame =>
        {
            change(frame);
            var watch = Stopwatch.StartNew();
            desktop.Step();
            return watch.Elapsed.TotalMilliseconds;
        }).Order().ToArray();
        Report($"| {what} | {Frames} | {times[Frames / 2]:0.0} | {times[Frames * 99 / 100]:0.0} | {times[^1]:0.0} |");
    }

    private void Report(FormattableString line) => output.WriteLine(line.ToString(CultureInfo.InvariantCulture));

    private void Await(Task work) => desktop.StepUntil(() => work.IsCompleted, s_timeout);
}
