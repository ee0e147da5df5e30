namespace Engraver.Benchmarks.Stages;

/// <summary>Measures one stage: processor time of the process (not wall time), bytes allocated and bytes kept.</summary>
internal static class StageClock
{
    public static async Task<(StageFigure Figure, T Result)> MeasureAsync<T>(int entities, string stage, int repetitions, Func<Task<T>> run, Func<T, string> note)
    {
        var seconds = new double[repetitions];
        var (allocated, kept) = (0L, 0L);
        T result = default!;
        for (var i = 0; i < repetitions; i++)
        {
            result = default!;
            var reachable = GC.GetTotalMemory(forceFullCollection: true);
            var bytes = GC.GetTotalAllocatedBytes(precise: true);
            var before = Environment.CpuUsage.TotalTime;
            result = await run().ConfigureAwait(false);
            seconds[i] = (Environment.CpuUsage.TotalTime - before).TotalSeconds;
            allocated = GC.GetTotalAllocatedBytes(precise: true) - bytes;
            if (i == 0) kept = GC.GetTotalMemory(forceFullCollection: true) - reachable; // later repetitions replace a result that may still be reachable
        }

        Array.Sort(seconds);
        var figure = new StageFigure(entities, stage, seconds[repetitions / 2], (double)allocated / entities, Math.Max(0.0, (double)kept / entities), note(result));
        return (figure, result);
    }

    public static Task<(StageFigure Figure, T Result)> MeasureAsync<T>(int entities, string stage, int repetitions, Func<T> run, Func<T, string> note) =>
        MeasureAsync(entities, stage, repetitions, () => Task.FromResult(run()), note);
}
