namespace Engraver.Simulator.Protocol;

/// <summary>The serial port on a pseudo-terminal: a thread waits for the host's bytes, two tasks carry bytes at the speed of the line.</summary>
internal sealed class SerialFrontEnd : IAsyncDisposable
{
    /// <summary>Bytes that go over the wire before the controller sees them: few, so that time does not jump over a long download.</summary>
    private const int Portion = 32;

    /// <summary>Wait before writing again to a host that does not read; wall time, because it is the operating system's buffer that must empty.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromMilliseconds(5);

    private readonly ControllerCore _core;
    private readonly PseudoTerminal _terminal;
    private readonly string _path;
    private readonly SimulatorOptions _options;
    private readonly TimeSpan _byteTime;
    private readonly Handle _handle;
    private readonly Action<ReadOnlyMemory<byte>, bool>? _heard;
    private readonly ByteQueue _incoming = new();
    private readonly CancellationTokenSource _stopping = new();
    private readonly TaskCompletionSource _listenerEnded = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Task _serving;

    private SerialFrontEnd(ControllerCore core, PseudoTerminal terminal, string path, int baud, SimulatorOptions options, Action<ReadOnlyMemory<byte>, bool>? heard)
    {
        (_core, _terminal, _path, _options, _heard) = (core, terminal, path, options, heard);
        _byteTime = options.IsVirtual ? TimeSpan.Zero : TimeSpan.FromSeconds(10.0 / baud / options.Speed);
        _handle = core.OpenSerial(baud, terminal.Ring) ?? throw new IOException("The serial port has a client.");
        new Thread(Listen) { IsBackground = true, Name = "serial port" }.Start();
        _serving = Task.WhenAll(core.WatchAsync(ReceiveAsync(_stopping.Token)), core.WatchAsync(SendAsync(_stopping.Token)));
    }

    /// <param name="heard">Told all bytes as they pass, and whether the host sent them; on the threads that carry them. Null for nobody.</param>
    /// <exception cref="IOException">The path is taken, the port already has a client, or the system has no free terminal.</exception>
    /// <exception cref="PlatformNotSupportedException">This is not Linux.</exception>
    public static SerialFrontEnd Open(ControllerCore core, string path, int baud, SimulatorOptions options, Action<ReadOnlyMemory<byte>, bool>? heard)
    {
        if (!OperatingSystem.IsLinux()) throw new PlatformNotSupportedException("the simulated serial port is built for Linux only so far; serve TCP instead.");
        var terminal = PseudoTerminal.Open();
        try
        {
            TerminalLink.Create(path, terminal.SlaveName);
            return new SerialFrontEnd(core, terminal, path, baud, options, heard);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            TerminalLink.Remove(path, terminal.SlaveName);
            terminal.Dispose();
            throw;
        }
    }

    public async ValueTask DisposeAsync()
    {
        _terminal.Ring();
        await _listenerEnded.Task.ConfigureAwait(false);
        await _serving.ConfigureAwait(false);
        _stopping.Dispose();
    }

    /// <summary>Reads until the port is closed, and is the only place that closes it: woken when the controller is disposed or the link is cut.</summary>
    private void Listen()
    {
        var buffer = new byte[4096];
        try
        {
            while (_terminal.WaitAndRead(buffer) is > 0 and var count)
            {
                _heard?.Invoke(buffer.AsMemory(0, count), true);
                _incoming.Write(buffer.AsSpan(0, count));
            }
        }
        catch (IOException)
        {
            // The terminal is gone: nothing more will come.
        }

        _incoming.Complete();
        _stopping.Cancel();
        TerminalLink.Remove(_path, _terminal.SlaveName);
        _terminal.Dispose();
        _listenerEnded.TrySetResult();
    }

    private TimeSpan ByteTime() => _core.Machine.Serial.CarriesAtOnce ? TimeSpan.Zero : _byteTime;

    private async Task ReceiveAsync(CancellationToken cancellation)
    {
        var buffer = new byte[Portion];
        var wire = new BytePacer(_options.Time, ByteTime);
        try
        {
            while (await _incoming.ReadAsync(buffer, cancellation).ConfigureAwait(false) is > 0 and var count)
            {
                await wire.PassAsync(count, cancellation).ConfigureAwait(false);
                _core.Receive(_handle, buffer.AsSpan(0, count));
            }
        }
        catch (OperationCanceledException)
        {
            // The port is closed.
        }

        _core.Detach(_handle);
    }

    private async Task SendAsync(CancellationToken cancellation)
    {
        var buffer = new byte[Portion];
        var wire = new BytePacer(_options.Time, ByteTime);
        try
        {
            while (await _handle.Output.ReadAsync(buffer, cancellation).ConfigureAwait(false) is > 0 and var count)
            {
                await wire.PassAsync(count, cancellation).ConfigureAwait(false);
                _heard?.Invoke(buffer.AsMemory(0, count), false);
                for (var sent = 0; sent < count;)
                {
                    sent += _terminal.Write(buffer.AsSpan(sent, count - sent));
                    if (sent < count) await Task.Delay(Patience, TimeProvider.System, cancellation).ConfigureAwait(false);
                }
            }
        }
        catch (OperationCanceledException)
        {
            // The port is closed.
        }
        catch (ObjectDisposedException)
        {
            // The terminal was closed between two bytes.
        }
    }
}
