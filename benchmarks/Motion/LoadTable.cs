using System.Diagnostics;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Engraver.Benchmarks.Motion;

/// <summary>Runs a drawing many times in real time on a simulated controller while the computer is busy.</summary>
/// <param name="name">The console runner.</param>
internal sealed class LoadTable(string name)
{
    /// <summary>Parts of a run's time over the plan at which the machine waited for this computer.</summary>
    private const double Late = 1.02;

    /// <param name="load">Threads that compute without a pause.</param>
    /// <param name="runs">Number of runs.</param>
    /// <param name="atOnce">Runs at the same time, each with a controller of its own.</param>
    /// <param name="link">tcp, or the bits per second of a serial line.</param>
    /// <param name="options">Further options of the run.</param>
    public void Write(string drawing, string machine, int load, int runs, int atOnce, string link, IReadOnlyList<string> options)
    {
        using var done = new CancellationTokenSource();
        for (var i = 0; i < load; i++) new Thread(() => Compute(done.Token)) { IsBackground = true }.Start();
        var results = new LoadedRun[runs];
        var next = -1;
        var workers = Enumerable.Range(0, atOnce).Select(_ => new Thread(() =>
        {
            for (var run = Interlocked.Increment(ref next); run < runs; run = Interlocked.Increment(ref next)) Report(results[run] = RunOne(drawing, machine, link, options));
        })).ToList();
        workers.ForEach(worker => worker.Start());
        workers.ForEach(worker => worker.Join());
        done.Cancel();

        Console.WriteLine("| Part | Link | Load | Runs | Complete | Underruns | Over the plan by 2 % | Median seconds / plan | Largest |");
        Console.WriteLine("|---|---|---:|---:|---:|---:|---:|---:|---:|");
        var ratios = results.Select(run => run.Ratio).Order().ToList();
        var complete = results.Count(run => run.Outcome == "complete");
        Console.WriteLine(
            $"| {Path.GetFileNameWithoutExtension(drawing)} | {link} | {load} | {runs} | {complete} | {results.Sum(run => run.Underruns)} | {ratios.Count(ratio => ratio > Late)} | {ratios[runs / 2]:0.000} | {ratios[^1]:0.000} |");
        foreach (var failed in results.Where(run => run.Outcome != "complete")) Console.WriteLine($"{failed.Outcome}: {failed.Message}");
    }

    private static void Report(LoadedRun run) => Console.Error.WriteLine($"{run.Outcome} {run.Ratio:0.000} underruns {run.Underruns} {run.Message}");

    private static void Compute(CancellationToken done)
    {
        var sum = 0.0;
        while (!done.IsCancellationRequested) sum += Math.Sqrt(sum + 1.0);
    }

    private LoadedRun RunOne(string drawing, string machine, string link, IReadOnlyList<string> options)
    {
        var folder = Directory.CreateTempSubdirectory("engraver-load-");
        string[] line = link == "tcp" ? ["--tcp", "0"] : ["--serial", Path.Combine(folder.FullName, "line"), "--baud", link];
        using var simulator = Process.Start(new ProcessStartInfo(name, ["simulate", .. line, "--speed", "1", "--machine", machine]) { RedirectStandardOutput = true, UseShellExecute = false })!;
        try
        {
            var address = Address(simulator.StandardOutput, link);
            using var run = Process.Start(new ProcessStartInfo(name, ["run", drawing, "--connect", address, "--origin", "here", "--machine", machine, "--json", "--quiet", "--journal", Path.Combine(folder.FullName, "run.jsonl"), .. options]) { RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false })!;
            var text = run.StandardOutput.ReadToEnd();
            var error = run.StandardError.ReadToEnd();
            run.WaitForExit();
            return LoadedRun.Read(text, error);
        }
        finally
        {
            simulator.Kill();
            simulator.WaitForExit();
            folder.Delete(recursive: true);
        }
    }

    private static string Address(StreamReader output, string link)
    {
        while (output.ReadLine() is { } line)
        {
            if (Regex.Match(line, link == "tcp" ? @"tcp://\S+" : @"serial://\S+") is not { Success: true } found) continue;
            return link == "tcp" ? found.Value : $"{found.Value}?baud={link}";
        }

        throw new InvalidOperationException("the simulated controller did not start.");
    }

    /// <summary>What a run reported.</summary>
    /// <param name="Ratio">Its seconds over the planned ones.</param>
    private sealed record LoadedRun(string Outcome, string Message, int Underruns, double Ratio)
    {
        public static LoadedRun Read(string text, string error)
        {
            if (!text.StartsWith('{')) return new LoadedRun("none", error, 0, 0.0);
            using var report = JsonDocument.Parse(text);
            var root = report.RootElement;
            return new LoadedRun(
                root.GetProperty("outcome").GetString()!, root.TryGetProperty("message", out var message) ? message.GetString() ?? "" : "", root.GetProperty("underruns").GetInt32(), root.GetProperty("seconds").GetDouble() / root.GetProperty("plannedSeconds").GetDouble());
        }
    }
}
