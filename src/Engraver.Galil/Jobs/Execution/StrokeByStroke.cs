using Engraver.Core.Machines;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>The host commands each stroke: rapid to its start, its sequences one after the other, tool off.</summary>
internal sealed class StrokeByStroke(MotionProgram program, JobMachine machine, JobLedger ledger, JobLog log, ISequenceStrategy sequences) : IJobStrategy
{
    public ValueTask<JobStep> StartAsync() => sequences.StartAsync();

    public async ValueTask<JobStep> CutAsync()
    {
        for (var stroke = 0; stroke < program.Strokes.Count; stroke++)
        {
            if (await CutAsync(stroke).ConfigureAwait(false) is { Ends: true } end) return end;
        }

        return JobStep.Done;
    }

    public ValueTask StoppedAsync(int counter)
    {
        sequences.StoppedAt(counter);
        return ValueTask.CompletedTask;
    }

    private async ValueTask<JobStep> CutAsync(int index)
    {
        var stroke = program.Strokes[index];
        ledger.Enter(index, 0);
        if (await RapidMove.ToAsync(machine, stroke.Start).ConfigureAwait(false) is { Ends: true } lost) return lost;
        for (var i = 0; i < stroke.Sequences.Count; i++)
        {
            ledger.Enter(index, i);
            if (await sequences.CutAsync(stroke.Sequences[i]).ConfigureAwait(false) is { Ends: true } end) return end;
            log.SequenceDone();
        }

        return await machine.Tool.OffAsync().ConfigureAwait(false);
    }
}
