using System.Runtime.InteropServices;

namespace Engraver.App.Start;

/// <summary>SIGTERM and SIGINT while the desktop runs: stops the machine first, as the stop key does, then ends the program.</summary>
internal sealed class EndSignals : IDisposable
{
    private readonly Action _stop;
    private readonly Action _end;
    private readonly PosixSignalRegistration[] _registrations;

    /// <param name="stop">Stops the machine; on the thread of the signal.</param>
    /// <param name="end">Then ends the program; on the thread of the signal.</param>
    public EndSignals(Action stop, Action end)
    {
        (_stop, _end) = (stop, end);
        _registrations = [PosixSignalRegistration.Create(PosixSignal.SIGTERM, OnSignal), PosixSignalRegistration.Create(PosixSignal.SIGINT, OnSignal)];
    }

    /// <summary>True after a signal has been received.</summary>
    public bool WasReceived { get; private set; }

    public void Dispose()
    {
        foreach (var registration in _registrations) registration.Dispose();
    }

    private void OnSignal(PosixSignalContext signal)
    {
        signal.Cancel = true;
        WasReceived = true;
        _stop();
        _end();
    }
}
