namespace Engraver.Galil.Jobs;

/// <summary>Ends a phase when it is disposed: the phase that was in force before is restored.</summary>
internal readonly struct PhaseScope(JobMachine machine, Phase before) : IDisposable
{
    public void Dispose() => machine.Leave(before);
}
