using System.Collections.Concurrent;
using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Simulator;
using Engraver.TestKit;
using Xunit.Abstractions;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>Every kind of fault at any moment of everything a host does: nothing hangs, the tool is off afterwards, nothing wrong is called right, and the next host cuts the part at its place, or what is left of it, or is told why not.</summary>
/// <remarks>ENGRAVER_FAULT_CASES=N runs as many seeds; ENGRAVER_FAULT_FIRST=N begins at another. The output of the test counts how the cases ended.</remarks>
public sealed class FaultMatrixTests(ITestOutputHelper output)
{
    /// <summary>Cases that run beside one another: most of their time is a host's patience with a lost answer.</summary>
    private const int AtOnce = 6;

    private static readonly TimeSpan s_limit = TimeSpan.FromSeconds(60);
    private readonly Dictionary<(HostActivity, JobMode), ActivityExtent> _extents = [];

    [Fact]
    public async Task No_fault_at_any_moment_hangs_leaves_the_tool_on_or_makes_a_wrong_part_right()
    {
        foreach (var activity in Enum.GetValues<HostActivity>()) await MeasureAsync(activity);
        var (first, count) = (TestExtent.Number("ENGRAVER_FAULT_FIRST", 0), TestExtent.Cases(perCommit: 30, full: 1_500, "ENGRAVER_FAULT_CASES"));
        var wrong = new ConcurrentQueue<string>();
        var outcomes = new ConcurrentDictionary<string, int>(StringComparer.Ordinal);
        await Parallel.ForEachAsync(Enumerable.Range(first, count), new ParallelOptions { MaxDegreeOfParallelism = AtOnce }, async (seed, _) =>
        {
            var one = FaultCase.Create(seed, (activity, mode) => _extents[(activity, mode)]);
            var (outcome, faults) = await WithinLimitAsync(one);
            outcomes.AddOrUpdate($"{one.Fault.Kind,-12} {one.Activity,-9} {outcome}", 1, (_, before) => before + 1);
            foreach (var fault in faults) wrong.Enqueue(string.Create(CultureInfo.InvariantCulture, $"seed {seed} {one.Activity} {one.Mode} {Describe(one.Fault)}: {fault}"));
        });

        output.WriteLine(string.Join('\n', outcomes.OrderBy(entry => entry.Key, StringComparer.Ordinal).Select(entry => $"{entry.Key} {entry.Value}")));
        Assert.True(wrong.IsEmpty, string.Create(CultureInfo.InvariantCulture, $"{wrong.Count} of {count}:\n{string.Join('\n', wrong)}"));
        Assert.True(count < 30 || outcomes.Keys.Select(key => key[23..]).Distinct().Count() >= 4, string.Join(' ', outcomes.Keys)); // faults that harm nothing would prove nothing
    }

    private static async Task<(string Outcome, IReadOnlyList<string> Faults)> WithinLimitAsync(FaultCase one)
    {
        using var limit = new CancellationTokenSource(s_limit);
        await using var trial = new FaultTrial(one, limit);
        try
        {
            return await trial.TryAsync();
        }
        catch (OperationCanceledException)
        {
            return ("hung", ["it hung"]);
        }
    }

    /// <summary>How long an activity takes when nothing goes wrong. Only that of a job depends on its mode.</summary>
    private async Task MeasureAsync(HostActivity activity)
    {
        foreach (var mode in Enum.GetValues<JobMode>())
        {
            _extents[(activity, mode)] = activity switch
            {
                HostActivity.Stop => _extents[(HostActivity.Run, mode)],
                HostActivity.Holding => Part(_extents[(HostActivity.Run, mode)], 0.12, 120),
                HostActivity.Held => Part(_extents[(HostActivity.Run, mode)], FaultOperator.HeldSeconds, 800),
                HostActivity.Resuming or HostActivity.LeadIn => Part(_extents[(HostActivity.Run, mode)], 0.25, 250),
                HostActivity.Resume => _extents[(HostActivity.Run, mode)],
                _ when mode != JobMode.Stream && activity != HostActivity.Run => _extents[(activity, JobMode.Stream)],
                _ => await FaultTrial.MeasureAsync(activity, mode),
            };
        }
    }

    private static ActivityExtent Part(ActivityExtent whole, double seconds, long bytes) => new(seconds, bytes, whole.Segments) { IsPart = true };

    private static string Describe(ScheduledFault fault) => string.Create(
        CultureInfo.InvariantCulture, $"{fault.Kind} {fault.Axis}{(fault.Forward ? " forward" : "")} at {fault.AtSeconds:0.###}{(fault.AtByte is { } b ? $"byte {b}" : "")}{(fault.AtSegment is { } s ? $"segment {s}" : "")} for {fault.ForSeconds:0.##} x{fault.Count} {fault.Seconds}");
}
