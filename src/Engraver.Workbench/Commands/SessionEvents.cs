using Engraver.Workbench.Certificates;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Playback;

namespace Engraver.Workbench.Commands;

/// <summary>Propagates changes of one part of a session (document, machine, derivation, playback) to the others until disposed.</summary>
internal sealed class SessionEvents : IDisposable
{
    private readonly DocumentSession _document;
    private readonly PlateSession _plates;
    private readonly MachineSession _machine;
    private readonly DerivationSession _derivation;
    private readonly PlaybackSession _playback;
    private readonly CertificateMonitor _certificates;
    private readonly CancellationTokenSource _disposed = new();
    private PreparedJob? _certifiedJob;

    public SessionEvents(DocumentSession document, PlateSession plates, MachineSession machine, DerivationSession derivation, PlaybackSession playback, CertificateMonitor certificates)
    {
        (_document, _plates, _machine, _derivation, _playback, _certificates) = (document, plates, machine, derivation, playback, certificates);
        document.Changed += OnDocumentChanged;
        plates.Changed += OnDocumentChanged;
        derivation.Changed += OnDerived;
        machine.Changed += OnMachineChanged;
    }

    public void Dispose()
    {
        _disposed.Cancel();
        _document.Changed -= OnDocumentChanged;
        _plates.Changed -= OnDocumentChanged;
        _derivation.Changed -= OnDerived;
        _machine.Changed -= OnMachineChanged;
    }

    /// <summary>Passes the profile of the settings to the machine session. Disarms an armed job, because the drawing, the settings or the plate have changed,
    /// and hides the progress of the last job.</summary>
    private void OnDocumentChanged(object? sender, EventArgs e)
    {
        var state = _document.Current;
        var plate = _plates.Of(state);
        _machine.Profile = state.Settings.Machine;
        if (_machine.Arming.Armed is { Job: var job } && !job.IsOf(state, plate)) _machine.Arming.Disarm();
        if (_machine.Runs.Part is { } part && (!ReferenceEquals(part.Drawing, state.Drawing) || part.Settings != state.Settings)) _machine.Runs.ChoosePart(null);
        if (_machine.Runs.ShownJob is { } shown && !shown.IsOf(state, plate)) _machine.Runs.DismissJob();
    }

    private void OnDerived(object? sender, EventArgs e)
    {
        if (!ReferenceEquals(_playback.Motion, _derivation.Current.Motion)) _playback.Load(_derivation.Current.Motion);
        if (_derivation.Current is not { Job: { Motion.Program: { } program } job } derived)
        {
            _certifiedJob = null;
            _certificates.Reset();
            return;
        }

        if (ReferenceEquals(job, _certifiedJob)) return;
        _certifiedJob = job;
        _ = _certificates.CheckAsync(job, JobPlan.FitToLink(program, derived.Line, derived.Strategy, job.Drawing).Program, _disposed.Token);
    }

    /// <summary>The planned time depends on the serial line of the machine, the plate on the job that is resumed.</summary>
    private void OnMachineChanged(object? sender, EventArgs e)
    {
        _derivation.Line = _machine.Connection.Line;
        _plates.Resumed = _machine.Runs.Part?.Plate;
    }
}
