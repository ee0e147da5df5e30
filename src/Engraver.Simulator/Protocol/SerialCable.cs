namespace Engraver.Simulator.Protocol;

/// <summary>One pseudo-terminal between a host and the serial port, until the cable is disconnected: a thread waits for the host's bytes, and two tasks
/// transfer bytes at the speed of the line.</summary>
internal sealed class SerialCable : IDisposable
{
    /// <summary>Bytes transmitted before the controller receives them: few, so that time does not jump over a long download.</summary>
    private const int Portion = 32;

    /// <summary>Wait before writing again to a host that does not read; wall time, because the operating system's buffer must empty.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromMilliseconds(5);

    private readonly ControllerCore _core;
    private readonly SerialLineSetup _setup;
    private readonly PseudoTerminal _terminal;
    private readonly Handle _handle;
    private readonly ByteQueue _incoming = new();
    private readonly CancellationTokenSource _pulled = new();
    private readonly TaskCompletionSource _listenerEnded = new(TaskCreationOptions.RunContinuationsAsynchronously);

    private SerialCable(ControllerCore core, SerialLineSetup setup, PseudoTerminal terminal, Handle handle) => (_core, _setup, _terminal, _handle) = (core, setup, terminal, handle);

    /// <summary>Creates the terminal and its link, and connects it.</summary>
    /// <exception cref="IOException">The path is in use, the port already has a client, or the system has no free terminal.</exception>
    /// <exception cref="UnauthorizedAccessException">The path cannot be written.</exception>
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

    /// <summary>Transfers bytes until the cable is disconnected; the terminal and its link are then removed. A host that disconnects is not detected, as on a
    /// real line.</summary>
    public async Task ServeAsync()
    {
        new Thread(Listen) { IsBackground = true, Name = "serial port" }.Start();
        await Task.WhenAll(ReceiveAsync(_pulled.Token), SendAsync(_pulled.Token), _listenerEnded.Task).ConfigureAwait(false);
    }

    /// <summary>Disconnects the cable; can be called from any thread. <see cref="ServeAsync"/> then ends.</summary>
    public void Pull() => _terminal.Ring();

    public void Dispose() => _pulled.Dispose();

    /// <summary>Reads until the cable is disconnected, from here or from the controller's side. Only this method closes the terminal.</summary>
    private void Listen()
    {
        var buffer = new byte[4096];
        try
        {
            while (_terminal.WaitAndRead(buffer) is > 0 and var count)
            {
                _setup.Received?.Invoke(buffer.AsMemory(0, count), true);
                _incoming.Write(buffer.AsSpan(0, count));
            }
        }
        catch (IOException)
        {
            // The terminal no longer exists: no more bytes will arrive.
        }

        _incoming.Complete();
        _pulled.Cancel();
        TerminalLink.Remove(_setup.Path, _terminal.SlaveName);
        _terminal.Dispose();
        _listenerEnded.TrySetResult();
    }

    private TimeSpan ByteTime() => _core.Machine.Serial.IsInstant ? TimeSpan.Zero : _setup.ByteTime;

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
            // The cable is disconnected.
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
                _setup.Received?.Invoke(buffer.AsMemory(0, count), false);
                for (var sent = 0; sent < count;)
                {
                    sent += _terminal.Write(buffer.AsSpan(sent, count - sent));
                    if (sent < count) await Task.Delay(Patience, TimeProvider.System, cancellation).ConfigureAwait(false);
                }
            }
        }
        catch (OperationCanceledException)
        {
            // The cable is disconnected.
        }
        catch (ObjectDisposedException)
        {
            // The terminal was closed between two bytes.
        }
    }
}

/// <summary>Settings with which the serial port is served, also after each disconnection of its cable.</summary>
/// <param name="Path">Path at which a symbolic link to the terminal is created.</param>
/// <param name="Baud">Bits per second in each direction.</param>
/// <param name="ByteTime">Wall time of a byte; zero at speed max, where a byte takes only controller time.</param>
/// <param name="Time">The wall clock.</param>
/// <param name="Received">Called with all bytes as they pass and a flag that is true for bytes from the host, on the threads that transfer them. Null for no
/// callback.</param>
internal sealed record SerialLineSetup(string Path, int Baud, TimeSpan ByteTime, TimeProvider Time, Action<ReadOnlyMemory<byte>, bool>? Received);
