using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Playback;

namespace Engraver.Workbench.Commands;

/// <summary>What follows from a change of one part of a session in the others, from the beginning of the session to its end.</summary>
internal sealed class SessionTies : IDisposable
{
    private readonly DocumentSession _document;
    private readonly MachineSession _machine;
    private readonly DerivationSession _derivation;
    private readonly PlaybackSession _playback;

    public SessionTies(DocumentSession document, MachineSession machine, DerivationSession derivation, PlaybackSession playback)
    {
        (_document, _machine, _derivation, _playback) = (document, machine, derivation, playback);
        document.Changed += OnDocumentChanged;
        derivation.Changed += OnDerived;
        machine.Changed += OnMachineChanged;
    }

    public void Dispose()
    {
        _document.Changed -= OnDocumentChanged;
        _derivation.Changed -= OnDerived;
        _machine.Changed -= OnMachineChanged;
    }

    /// <summary>The machine is the one of the settings; what was armed from another drawing or other settings is not what would run now.</summary>
    private void OnDocumentChanged(object? sender, EventArgs e)
    {
        var state = _document.Current;
        _machine.Profile = state.Settings.Machine;
        if (_machine.Armed is { Job: var job } && (!ReferenceEquals(job.Drawing, state.Drawing) || job.Settings != state.Settings)) _machine.Disarm();
    }

    private void OnDerived(object? sender, EventArgs e)
    {
        if (!ReferenceEquals(_playback.Motion, _derivation.Current.Motion)) _playback.Load(_derivation.Current.Motion);
    }

    /// <summary>How long the job takes depends on the line it goes over.</summary>
    private void OnMachineChanged(object? sender, EventArgs e) => _derivation.Line = _machine.Line;
}
