namespace Engraver.Simulator.Protocol;

/// <summary>One pseudo-terminal between a host and the serial port, until it is pulled: a thread waits for the host's bytes, two tasks carry bytes at the speed
/// of the line.</summary>
internal sealed class SerialCable : IDisposable
{
    /// <summary>Bytes that go over the wire before the controller sees them: few, so that time does not jump over a long download.</summary>
    private const int Portion = 32;

    /// <summary>Wait before writing again to a host that does not read; wall time, because it is the operating system's buffer that must empty.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromMilliseconds(5);

    private readonly ControllerCore _core;
    private readonly SerialLineSetup _setup;
    private readonly PseudoTerminal _terminal;
    private readonly Handle _handle;
    private readonly ByteQueue _incoming = new();
    private readonly CancellationTokenSource _pulled = new();
    private readonly TaskCompletionSource _listenerEnded = new(TaskCreationOptions.RunContinuationsAsynchronously);

    private SerialCable(ControllerCore core, SerialLineSetup setup, PseudoTerminal terminal, Handle handle) => (_core, _setup, _terminal, _handle) = (core, setup, terminal, handle);

    /// <summary>Makes the terminal and its link, and plugs it in.</summary>
    /// <exception cref="IOException">The path is taken, the port already has a client, or the system has no free terminal.</exception>
    /// <exception cref="UnauthorizedAccessException">The path may not be written.</exception>
    public static SerialCable Plug(ControllerCore core, SerialLineSetup setup)
    {
        var terminal = PseudoTerminal.Open();
        try
        {
            TerminalLink.Create(setup.Path, terminal.SlaveName);
            return new SerialCable(core, setup, terminal, core.OpenSerial(setup.Baud, terminal.Ring) ?? throw new IOException("The serial port has a client."));
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            TerminalLink.Remove(setup.Path, terminal.SlaveName);
            terminal.Dispose();
            throw;
        }
    }

    /// <summary>Carries bytes until the cable is pulled; the terminal and its link are gone then. A host that leaves is not noticed, as on a real
    /// line.</summary>
    public async Task ServeAsync()
    {
        new Thread(Listen) { IsBackground = true, Name = "serial port" }.Start();
        await Task.WhenAll(ReceiveAsync(_pulled.Token), SendAsync(_pulled.Token), _listenerEnded.Task).ConfigureAwait(false);
    }

    /// <summary>Pulls the cable from any thread: <see cref="ServeAsync"/> ends.</summary>
    public void Pull() => _terminal.Ring();

    public void Dispose() => _pulled.Dispose();

    /// <summary>Reads until the cable is pulled, from here or from the controller's side, and is the only place that closes the terminal.</summary>
    private void Listen()
    {
        var buffer = new byte[4096];
        try
        {
            while (_terminal.WaitAndRead(buffer) is > 0 and var count)
            {
                _setup.Heard?.Invoke(buffer.AsMemory(0, count), true);
                _incoming.Write(buffer.AsSpan(0, count));
            }
        }
        catch (IOException)
        {
            // The terminal is gone: nothing more will come.
        }

        _incoming.Complete();
        _pulled.Cancel();
        TerminalLink.Remove(_setup.Path, _terminal.SlaveName);
        _terminal.Dispose();
        _listenerEnded.TrySetResult();
    }

    private TimeSpan ByteTime() => _core.Machine.Serial.CarriesAtOnce ? TimeSpan.Zero : _setup.ByteTime;

    private async Task ReceiveAsync(CancellationToken cancellation)
    {
        var buffer = new byte[Portion];
        var wire = new BytePacer(_setup.Time, ByteTime);
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
            // The cable is pulled.
        }

        _core.Detach(_handle);
    }

    private async Task SendAsync(CancellationToken cancellation)
    {
        var buffer = new byte[Portion];
        var wire = new BytePacer(_setup.Time, ByteTime);
        try
        {
            while (await _handle.Output.ReadAsync(buffer, cancellation).ConfigureAwait(false) is > 0 and var count)
            {
                await wire.PassAsync(count, cancellation).ConfigureAwait(false);
                _setup.Heard?.Invoke(buffer.AsMemory(0, count), false);
                for (var sent = 0; sent < count;)
                {
                    sent += _terminal.Write(buffer.AsSpan(sent, count - sent));
                    if (sent < count) await Task.Delay(Patience, TimeProvider.System, cancellation).ConfigureAwait(false);
                }
            }
        }
        catch (OperationCanceledException)
        {
            // The cable is pulled.
        }
        catch (ObjectDisposedException)
        {
            // The terminal was closed between two bytes.
        }
    }
}

/// <summary>What the serial port is served with, again after each time that its cable was pulled.</summary>
/// <param name="Path">A symbolic link to the terminal is made here.</param>
/// <param name="Baud">Bits per second in each direction.</param>
/// <param name="ByteTime">How long a byte takes on the wall; zero at speed max, where it takes its time on the controller's clock alone.</param>
/// <param name="Time">The wall.</param>
/// <param name="Heard">Told all bytes as they pass, and whether the host sent them; on the threads that carry them. Null for nobody.</param>
internal sealed record SerialLineSetup(string Path, int Baud, TimeSpan ByteTime, TimeProvider Time, Action<ReadOnlyMemory<byte>, bool>? Heard);
