using System.Collections.Concurrent;
using System.Globalization;
using Engraver.Galil.Language;
using Engraver.Simulator;
using Engraver.TestKit;
using Xunit.Abstractions;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>Every kind of fault at any time of every host activity, on a pen, a mill and a machine with steppers: nothing hangs, the tool is off or above the
/// work afterwards, no wrong part is reported as correct, message, state and alarm report the fault, and the next host cuts the part or its rest at the correct
/// position, or is refused with a reason and succeeds after the operator's remedy.</summary>
/// <remarks>ENGRAVER_FAULT_CASES=N runs as many seeds; ENGRAVER_FAULT_FIRST=N starts at another seed. The output of the test counts how the cases
/// ended.</remarks>
public sealed class FaultMatrixTests(ITestOutputHelper output)
{
    /// <summary>Number of concurrent cases: they mostly wait for timeouts of lost replies.</summary>
    private const int AtOnce = 6;

    private static readonly TimeSpan s_limit = TimeSpan.FromSeconds(60);
    private readonly Dictionary<(HostActivity, JobMode, MachineKind), ActivityExtent> _extents = [];

    [Fact]
    public async Task No_fault_at_any_moment_hangs_leaves_the_tool_on_or_makes_a_wrong_part_right()
    {
        foreach (var machine in Enum.GetValues<MachineKind>()) await MeasureAsync(machine);
        var (first, count) = (TestExtent.Number("ENGRAVER_FAULT_FIRST", 0), TestExtent.Cases(perCommit: 24, full: 1_800, "ENGRAVER_FAULT_CASES"));
        var wrong = new ConcurrentQueue<string>();
        var outcomes = new ConcurrentDictionary<string, int>(StringComparer.Ordinal);
        await Parallel.ForEachAsync(Enumerable.Range(first, count), new ParallelOptions { MaxDegreeOfParallelism = AtOnce }, async (seed, _) =>
        {
            var one = FaultCase.Create(seed, (activity, mode, machine) => _extents[(activity, mode, machine)]);
            var (outcome, faults) = await WithinLimitAsync(one);
            outcomes.AddOrUpdate($"{one.Fault.Kind,-12} {one.Machine,-8}{one.Activity,-11}{outcome}", 1, (_, before) => before + 1);
            foreach (var fault in faults) wrong.Enqueue(string.Create(CultureInfo.InvariantCulture, $"seed {seed} {one.Machine} {one.Activity} {one.Mode} {Describe(one.Fault)}: {fault}"));
        });

        output.WriteLine(string.Join('\n', outcomes.OrderBy(entry => entry.Key, StringComparer.Ordinal).Select(entry => $"{entry.Key} {entry.Value}")));
        Assert.True(wrong.IsEmpty, string.Create(CultureInfo.InvariantCulture, $"{wrong.Count} of {count}:\n{string.Join('\n', wrong)}"));
        Assert.True(count < 24 || outcomes.Keys.Select(key => key[32..]).Distinct().Count() >= 4, string.Join(' ', outcomes.Keys)); // Faults without effect would prove nothing.
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
        catch (Exception broken) when (broken is not OutOfMemoryException)
        {
            return ("threw", [broken.ToString()]); // Failure of one case; the others are tested anyway.
        }
    }

    /// <summary>Durations without a fault. That of a job depends on its mode (calls have no segments at corners); steppers take as long as a pen.</summary>
    private async Task MeasureAsync(MachineKind machine)
    {
        foreach (var mode in Enum.GetValues<JobMode>())
        {
            var run = _extents[(HostActivity.Run, mode, machine)] = machine switch
            {
                MachineKind.Stepper => _extents[(HostActivity.Run, mode, MachineKind.Pen)],
                MachineKind.Mill when mode == JobMode.Program => _extents[(HostActivity.Run, JobMode.Stream, machine)],
                _ => await FaultTrial.MeasureAsync(HostActivity.Run, mode, machine),
            };
            foreach (var activity in Enum.GetValues<HostActivity>().Where(activity => activity != HostActivity.Run)) _extents[(activity, mode, machine)] = activity switch
            {
                HostActivity.Stop or HostActivity.Resume => run,
                HostActivity.Holding => Part(run, 0.12, 120),
                HostActivity.Held => Part(run, FaultOperator.HeldSeconds, 800),
                HostActivity.Resuming or HostActivity.LeadIn => Part(run, 0.25, 250),
                HostActivity.Away => Part(run, 1.0, 1_200),
                HostActivity.ComingBack => Part(run, 0.5, 600),
                _ when mode != JobMode.Stream || machine != MachineKind.Pen => _extents[(activity, JobMode.Stream, MachineKind.Pen)],
                _ => await FaultTrial.MeasureAsync(activity, mode, machine),
            };
        }
    }

    private static ActivityExtent Part(ActivityExtent whole, double seconds, long bytes) => new(seconds, bytes, whole.Segments) { IsPart = true };

    private static string Describe(ScheduledFault fault) => string.Create(
        CultureInfo.InvariantCulture, $"{fault.Kind} {fault.Axis}{(fault.Forward ? " forward" : "")} at {fault.AtSeconds:0.###}{(fault.AtByte is { } b ? $"byte {b}" : "")}{(fault.AtSegment is { } s ? $"segment {s}" : "")} for {fault.ForSeconds:0.##} x{fault.Count} {fault.Seconds}");
}
