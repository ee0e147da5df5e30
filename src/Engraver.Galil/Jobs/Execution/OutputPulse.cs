namespace Engraver.Galil.Jobs.Execution;

/// <summary>The tool's output on for the profile's settle time and off again, while nothing moves.</summary>
internal sealed class OutputPulse(JobMachine machine) : IJobStrategy
{
    public Phase Whole => Phase.Idle;

    public ValueTask StartAsync() => ValueTask.CompletedTask;

    public async ValueTask CutAsync()
    {
        await machine.Tool.OnAsync(machine.Here).ConfigureAwait(false);
        await machine.Tool.OffAsync().ConfigureAwait(false);
    }

    public ValueTask StoppedAsync(int counter) => ValueTask.CompletedTask;
}
