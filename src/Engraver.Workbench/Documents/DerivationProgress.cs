using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>Progress of the derivation. Any thread.</summary>
public sealed class DerivationProgress
{
    private volatile JobStage? _stage;

    /// <summary>Raised with each stage and at the end, on the computing thread.</summary>
    public event EventHandler? Changed;

    /// <summary>The stage being computed; null while idle.</summary>
    public JobStage? Stage => _stage;

    /// <summary>Creates the reporter of one computation; its reports after cancellation are ignored.</summary>
    internal IProgress<JobStage> CreateReporter(CancellationToken cancellation) => new StageReporter(this, cancellation);

    internal void End() => Set(null);

    private void Set(JobStage? stage)
    {
        if (ReferenceEquals(_stage, stage)) return;
        _stage = stage;
        Changed?.Invoke(this, EventArgs.Empty);
    }

    private sealed class StageReporter(DerivationProgress owner, CancellationToken cancellation) : IProgress<JobStage>
    {
        public void Report(JobStage value)
        {
            if (!cancellation.IsCancellationRequested) owner.Set(value);
        }
    }
}
