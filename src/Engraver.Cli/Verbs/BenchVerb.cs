using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Engraver.Benchmarks.Stages;

namespace Engraver.Cli.Verbs;

/// <summary><c>engraver bench</c>: the tables of docs/benchmarks.md.</summary>
internal static class BenchVerb
{
    public static Command Build(VerbHost host)
    {
        var sizes = new Argument<int[]>("ENTITIES")
        {
            Description = Wording.Get("Bench.LinesMeasuredDrawingsDefault"),
            Arity = ArgumentArity.ZeroOrMore,
            DefaultValueFactory = _ => [1_000, 10_000, 100_000],
            CustomParser = Sizes,
        };
        var command = new Command("bench", Wording.Get("Bench.MeasuresEveryStageOn")) { sizes };
        command.SetAction((parsed, stop) => RunAsync(host, parsed.GetRequiredValue(sizes), stop));
        return command;
    }

    private static async Task<int> RunAsync(VerbHost host, int[] sizes, CancellationToken stop)
    {
        await StageBenchmark.WarmUpAsync(stop).ConfigureAwait(false);
        await SayAsync(host, StageFigure.MarkdownHead, stop).ConfigureAwait(false);
        foreach (var size in sizes)
        {
            foreach (var row in await StageBenchmark.RunAsync(size, stop).ConfigureAwait(false)) await SayAsync(host, row.ToMarkdown(), stop).ConfigureAwait(false);
        }

        return ExitCode.Done;
    }

    /// <summary>At once, for the next row may take minutes.</summary>
    private static async Task SayAsync(VerbHost host, string line, CancellationToken stop)
    {
        await host.Out.WriteLineAsync(line.AsMemory(), stop).ConfigureAwait(false);
        await host.Out.FlushAsync(stop).ConfigureAwait(false);
    }

    private static int[] Sizes(ArgumentResult result)
    {
        var sizes = new List<int>();
        foreach (var token in result.Tokens)
        {
            if (int.TryParse(token.Value, NumberStyles.None, CultureInfo.InvariantCulture, out var size) && size is > 0 and <= 10_000_000) sizes.Add(size);
            else result.AddError(Wording.Get("Bench.EntitiesNotNumberFrom", token.Value));
        }

        return [.. sizes];
    }
}
