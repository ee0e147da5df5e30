namespace Engraver.Simulator.Protocol;

/// <summary>The serial port on a pseudo-terminal. When the controller cuts its links (a fault that resets them, a power cycle), the host sees a hang-up, and
/// the port is served again on a new terminal at the same path.</summary>
internal sealed class SerialFrontEnd : IAsyncDisposable
{
    private readonly ControllerCore _core;
    private readonly SerialLineSetup _setup;
    private readonly Lock _gate = new();
    private readonly Task _serving;
    private SerialCable _cable;
    private bool _isDisposed;

    private SerialFrontEnd(ControllerCore core, SerialLineSetup setup)
    {
        (_core, _setup, _cable) = (core, setup, SerialCable.Plug(core, setup));
        _serving = core.WatchAsync(ServeAsync());
    }

    /// <param name="heard">Called with all bytes as they pass and a flag that is true for bytes from the host, on the threads that transfer them. Null for no
    /// callback.</param>
    /// <exception cref="IOException">The path is in use, the port already has a client, or the system has no free terminal.</exception>
    /// <exception cref="PlatformNotSupportedException">The operating system is not Linux.</exception>
    public static SerialFrontEnd Open(ControllerCore core, string path, int baud, SimulatorOptions options, Action<ReadOnlyMemory<byte>, bool>? heard)
    {
        if (!OperatingSystem.IsLinux()) throw new PlatformNotSupportedException("the simulated serial port is built for Linux only so far; serve TCP instead.");
        var byteTime = options.IsVirtual ? TimeSpan.Zero : TimeSpan.FromSeconds(10.0 / baud / options.Speed);
        return new SerialFrontEnd(core, new SerialLineSetup(path, baud, byteTime, options.Time, heard));
    }

    public async ValueTask DisposeAsync()
    {
        lock (_gate)
        {
            _isDisposed = true;
            _cable.Pull();
        }

        await _serving.ConfigureAwait(false);
    }

    private async Task ServeAsync()
    {
        do
        {
            using var cable = _cable;
            await cable.ServeAsync().ConfigureAwait(false);
        }
        while (PlugAgain());
    }

    /// <summary>Connects a new cable, unless the port is disposed or the controller has stopped after an internal error: then the port does not
    /// answer.</summary>
    private bool PlugAgain()
    {
        lock (_gate)
        {
            if (_isDisposed || _core.Broken.IsCompleted) return false;
            _cable = SerialCable.Plug(_core, _setup);
            return true;
        }
    }
}
