using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Engraver.Benchmarks.Links;
using Engraver.Benchmarks.Offsets;
using Engraver.Benchmarks.Plans;
using Engraver.Benchmarks.Pockets;
using Engraver.Benchmarks.Posts;
using Engraver.Benchmarks.Stages;
using Engraver.Benchmarks.Stops;
using Engraver.Benchmarks.Trajectories;
using Engraver.Cli.Options;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver bench</c>: the tables of docs/benchmarks.md.</summary>
internal static class BenchVerb
{
    /// <summary>Maximum size in bytes of a drawing that is posted for every target.</summary>
    private const long MaxPostedEntities = 100_000;
    private const int PostSeed = 15;

    public static Command Build(VerbHost host)
    {
        var sizes = new Argument<int[]>("ENTITIES")
        {
            Description = Wording.Get("Bench.Sizes"),
            Arity = ArgumentArity.ZeroOrMore,
            DefaultValueFactory = _ => [1_000, 10_000, 100_000],
            CustomParser = Sizes,
        };
        var command = new Command("bench", Wording.Get("Bench.Summary")) { sizes };
        command.SetAction((parsed, stop) => RunAsync(host, parsed.GetRequiredValue(sizes), stop));
        command.Subcommands.Add(Stops(host));
        command.Subcommands.Add(Links(host));
        command.Subcommands.Add(Trajectories(host));
        command.Subcommands.Add(Offsets(host));
        command.Subcommands.Add(Pockets(host));
        command.Subcommands.Add(Plans(host));
        command.Subcommands.Add(Posts(host));
        return command;
    }

    /// <summary><c>engraver bench stop</c>: how long a STOP takes to the wire under each kind of fault.</summary>
    private static Command Stops(VerbHost host)
    {
        var presses = new Option<int>("--presses") { HelpName = "N", Description = Wording.Get("Bench.Presses"), DefaultValueFactory = _ => 200 };
        presses.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && !(int.TryParse(token.Value, NumberStyles.None, CultureInfo.InvariantCulture, out var count) && count is > 0 and <= 10_000)) result.AddError(Wording.Get("Bench.InvalidPresses", token.Value));
        });
        var names = new Option<string[]>("--fault") { HelpName = "KIND", Description = Wording.Get("Bench.Fault"), Arity = ArgumentArity.OneOrMore, AllowMultipleArgumentsPerToken = true };
        names.AcceptOnlyFromAmong([.. FaultStopBenchmark.Faults.Select(fault => fault.Name)]);
        var serial = new Option<int?>("--serial") { HelpName = "BAUD", Description = Wording.Get("Bench.Serial"), CustomParser = Baud };
        var driver = DriverOption();
        var command = new Command("stop", Wording.Get("Bench.Stops")) { presses, names, serial, driver };
        command.Validators.Add(result =>
        {
            if (result.GetResult(driver) is not null && result.GetResult(serial) is null) result.AddError(Wording.Get("Bench.DriverNeedsSerial"));
        });
        command.SetAction((parsed, stop) => StopAsync(host, parsed.GetValue(presses), parsed.GetValue(names) ?? [], parsed.GetValue(serial), parsed.GetValue(driver), stop));
        return command;
    }

    /// <summary><c>engraver bench links</c>: the drivers of serial devices.</summary>
    private static Command Links(VerbHost host)
    {
        var exchanges = new Option<double>("--exchanges") { HelpName = "N", Description = Wording.Get("Bench.Exchanges"), CustomParser = OptionValue.IntegerFromOne, DefaultValueFactory = _ => 2000.0 };
        var rest = new Option<double>("--rest") { HelpName = "SECONDS", Description = Wording.Get("Bench.Rest"), CustomParser = OptionValue.SecondsOfADay, DefaultValueFactory = _ => 5.0 };
        var command = new Command("links", Wording.Get("Bench.Links")) { exchanges, rest };
        command.SetAction((parsed, stop) => OnLinuxAsync(() => LinksAsync(host, (int)parsed.GetValue(exchanges), TimeSpan.FromSeconds(parsed.GetValue(rest)), stop)));
        return command;
    }

    /// <summary><c>engraver bench trajectories</c>: number of points, error bounds and measured errors of trajectories.</summary>
    private static Command Trajectories(VerbHost host)
    {
        var curves = new Option<int>("--curves") { HelpName = "N", Description = Wording.Get("Bench.Curves"), DefaultValueFactory = _ => 100 };
        curves.Validators.Add(result =>
        {
            if (result.Tokens is [var token] && !(int.TryParse(token.Value, NumberStyles.None, CultureInfo.InvariantCulture, out var count) && count is > 0 and <= 10_000)) result.AddError(Wording.Get("Bench.InvalidCurves", token.Value));
        });
        var command = new Command("trajectories", Wording.Get("Bench.Trajectories")) { curves };
        command.SetAction((parsed, stop) => TrajectoriesAsync(host, parsed.GetValue(curves), stop));
        return command;
    }

    /// <summary><c>engraver bench offsets</c>: processor time of offsets and its growth.</summary>
    private static Command Offsets(VerbHost host)
    {
        var sizes = new Argument<int[]>("VERTICES") { Description = Wording.Get("Bench.Vertices"), Arity = ArgumentArity.ZeroOrMore, DefaultValueFactory = _ => [10_000, 100_000], CustomParser = Sizes };
        var command = new Command("offsets", Wording.Get("Bench.Offsets")) { sizes };
        command.SetAction(async (parsed, stop) =>
        {
            await WriteAsync(host, OffsetBenchmark.Head, stop).ConfigureAwait(false);
            foreach (var row in OffsetBenchmark.Rows(parsed.GetRequiredValue(sizes), stop)) await WriteAsync(host, row, stop).ConfigureAwait(false);
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary><c>engraver bench plans</c>: processor time of motion programs.</summary>
    private static Command Plans(VerbHost host)
    {
        var command = new Command("plans", Wording.Get("Bench.Plans"));
        command.SetAction(async (_, stop) =>
        {
            await WriteAsync(host, PlanBenchmark.Head, stop).ConfigureAwait(false);
            foreach (var row in PlanBenchmark.Rows(stop)) await WriteAsync(host, row, stop).ConfigureAwait(false);
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary><c>engraver bench pockets</c>: processor time of pockets.</summary>
    private static Command Pockets(VerbHost host)
    {
        var command = new Command("pockets", Wording.Get("Bench.Pockets"));
        command.SetAction(async (_, stop) =>
        {
            await WriteAsync(host, PocketBenchmark.Head, stop).ConfigureAwait(false);
            foreach (var row in PocketBenchmark.Rows(stop)) await WriteAsync(host, row, stop).ConfigureAwait(false);
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary><c>engraver bench posts</c>: posts and verifies real drawings for every target.</summary>
    private static Command Posts(VerbHost host)
    {
        var places = new Argument<string[]>("PLACE") { Description = Wording.Get("Bench.PostDrawings"), Arity = ArgumentArity.OneOrMore };
        places.Validators.Add(result =>
        {
            foreach (var place in result.Tokens.Where(token => !Path.Exists(token.Value))) result.AddError(Wording.Get("Bench.NotDrawingOrFolder", place.Value));
        });
        var most = new Option<double>("--most") { HelpName = "N", Description = Wording.Get("Bench.PostMaxDrawings"), CustomParser = OptionValue.IntegerFromOne, DefaultValueFactory = _ => 60.0 };
        var target = new Option<string?>("--target") { HelpName = "NAME", Description = Wording.Get("Bench.PostTarget") };
        target.AcceptOnlyFromAmong([.. PostTable.All.Select(entry => entry.Post.Name)]);
        var each = new Option<bool>("--each") { Description = Wording.Get("Bench.PostEach") };
        var command = new Command("posts", Wording.Get("Bench.Posts")) { places, most, target, each };
        command.SetAction(async (parsed, stop) =>
        {
            var files = PostBenchmark.Choose(parsed.GetRequiredValue(places), (int)parsed.GetValue(most), MaxPostedEntities, PostSeed);
            await WriteAsync(host, PostBenchmark.Head, stop).ConfigureAwait(false);
            await foreach (var row in PostBenchmark.RowsAsync(files, parsed.GetValue(target), parsed.GetValue(each), stop).ConfigureAwait(false)) await WriteAsync(host, row, stop).ConfigureAwait(false);
            return ExitCode.Done;
        });
        return command;
    }

    private static async Task<int> TrajectoriesAsync(VerbHost host, int curves, CancellationToken stop)
    {
        TrajectoryBenchmark.WarmUp(stop);
        await WriteAsync(host, TrajectoryBenchmark.ShapesHead, stop).ConfigureAwait(false);
        foreach (var row in TrajectoryBenchmark.Rows(stop)) await WriteAsync(host, row, stop).ConfigureAwait(false);
        await WriteAsync(host, "", stop).ConfigureAwait(false);
        await WriteAsync(host, TrajectoryBenchmark.CurvesHead, stop).ConfigureAwait(false);
        await WriteAsync(host, TrajectoryBenchmark.Curves(curves, stop), stop).ConfigureAwait(false);
        return ExitCode.Done;
    }

    private static Option<string?> DriverOption()
    {
        var driver = new Option<string?>("--driver") { HelpName = "NAME", Description = Wording.Get("Bench.Driver") };
        driver.AcceptOnlyFromAmong([.. Enum.GetValues<SerialDriver>().Select(SerialDrivers.Name)]);
        return driver;
    }

    private static async Task<int> LinksAsync(VerbHost host, int exchanges, TimeSpan rest, CancellationToken stop)
    {
        await WriteAsync(host, LinkBenchmark.ExchangeHead, stop).ConfigureAwait(false);
        foreach (var driver in LinkBenchmark.Drivers) await WriteAsync(host, await LinkBenchmark.ExchangesAsync(driver, exchanges, rest, stop).ConfigureAwait(false), stop).ConfigureAwait(false);
        await WriteAsync(host, "", stop).ConfigureAwait(false);
        await WriteAsync(host, LinkBenchmark.EndHead, stop).ConfigureAwait(false);
        foreach (var end in LinkBenchmark.Ends)
        {
            foreach (var driver in LinkBenchmark.Drivers) await WriteAsync(host, await LinkBenchmark.EndAsync(end, driver, stop).ConfigureAwait(false), stop).ConfigureAwait(false);
        }

        return ExitCode.Done;
    }

    /// <summary>Runs a measurement that needs a pseudo-terminal.</summary>
    private static async Task<int> OnLinuxAsync(Func<Task<int>> measure)
    {
        try
        {
            return await measure().ConfigureAwait(false);
        }
        catch (PlatformNotSupportedException unbuilt)
        {
            throw new UsageException(Wording.Get("Bench.SerialUnavailable", unbuilt.Message));
        }
    }

    private static Task<int> StopAsync(VerbHost host, int presses, string[] names, int? baud, string? driver, CancellationToken stop) => OnLinuxAsync(() => MeasureStopsAsync(host, presses, names, baud, driver, stop));

    private static async Task<int> MeasureStopsAsync(VerbHost host, int presses, string[] names, int? baud, string? driver, CancellationToken stop)
    {
        var folder = Directory.CreateTempSubdirectory("engraver-bench-");
        try
        {
            var benchmark = new FaultStopBenchmark(folder.FullName, baud, driver);
            await benchmark.RunAsync("none", null, baud is null ? 3 : 1, stop).ConfigureAwait(false); // JIT-compiles the measured code.
            await WriteAsync(host, baud is null ? FaultStopFigure.MarkdownHead : FaultStopFigure.SerialHead, stop).ConfigureAwait(false);
            foreach (var (name, fault) in FaultStopBenchmark.Faults.Where(fault => names.Length == 0 || names.Contains(fault.Name))) await WriteAsync(host, (await benchmark.RunAsync(name, fault, presses, stop).ConfigureAwait(false)).ToMarkdown(), stop).ConfigureAwait(false);
            return ExitCode.Done;
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    private static async Task<int> RunAsync(VerbHost host, int[] sizes, CancellationToken stop)
    {
        await StageBenchmark.WarmUpAsync(stop).ConfigureAwait(false);
        await WriteAsync(host, StageFigure.MarkdownHead, stop).ConfigureAwait(false);
        foreach (var size in sizes)
        {
            foreach (var row in await StageBenchmark.RunAsync(size, stop).ConfigureAwait(false)) await WriteAsync(host, row.ToMarkdown(), stop).ConfigureAwait(false);
        }

        return ExitCode.Done;
    }

    /// <summary>Writes a row immediately, because the next one may take minutes.</summary>
    private static async Task WriteAsync(VerbHost host, string line, CancellationToken stop)
    {
        await host.Out.WriteLineAsync(line.AsMemory(), stop).ConfigureAwait(false);
        await host.Out.FlushAsync(stop).ConfigureAwait(false);
    }

    private static int? Baud(ArgumentResult result)
    {
        if (result.Tokens is [var token] && int.TryParse(token.Value, NumberStyles.None, CultureInfo.InvariantCulture, out var baud) && SerialLine.Rates.Contains(baud)) return baud;
        result.AddError(Wording.Get("Bench.InvalidBaud", result.Tokens[0].Value, string.Join(", ", SerialLine.Rates)));
        return null;
    }

    private static int[] Sizes(ArgumentResult result)
    {
        var sizes = new List<int>();
        foreach (var token in result.Tokens)
        {
            if (int.TryParse(token.Value, NumberStyles.None, CultureInfo.InvariantCulture, out var size) && size is > 0 and <= 10_000_000) sizes.Add(size);
            else result.AddError(Wording.Get("Bench.InvalidCount", result.Argument.Name, token.Value));
        }

        return [.. sizes];
    }
}
