using System.Runtime.InteropServices;

namespace Engraver.App.Start;

/// <summary>SIGTERM and SIGINT while the desktop runs: the machine is stopped first, as by the stop key, then the program ends.</summary>
internal sealed class EndSignals : IDisposable
{
    private readonly Action _stop;
    private readonly Action _end;
    private readonly PosixSignalRegistration[] _registrations;

    /// <param name="stop">Stops the machine; on the signal's own thread.</param>
    /// <param name="end">Then ends the program; on the signal's own thread.</param>
    public EndSignals(Action stop, Action end)
    {
        (_stop, _end) = (stop, end);
        _registrations = [PosixSignalRegistration.Create(PosixSignal.SIGTERM, OnSignal), PosixSignalRegistration.Create(PosixSignal.SIGINT, OnSignal)];
    }

    /// <summary>True once a signal has come.</summary>
    public bool Came { get; private set; }

    public void Dispose()
    {
        foreach (var registration in _registrations) registration.Dispose();
    }

    private void OnSignal(PosixSignalContext signal)
    {
        signal.Cancel = true;
        Came = true;
        _stop();
        _end();
    }
}
