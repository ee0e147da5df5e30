using System.Globalization;
using Engraver.Core.Machines;

namespace Engraver.Links.Serial;

/// <summary>A link over an RS-232 line on Linux, or over a pseudo-terminal, by the kernel's own interface.</summary>
/// <remarks>One thread waits for the device in both directions, without a time limit and without polling. When an adapter is unplugged, this wait and all reads
/// and writes end with an <see cref="IOException"/>. Closing wakes the thread, so that it never waits for a byte.</remarks>
internal sealed class TermiosLink : ISerialLink
{
    private readonly SerialDevice _device;
    private readonly TimeProvider _time;
    private readonly TimeSpan _writeTimeout;
    private readonly ReceivedBytes _received = new();
    private readonly TaskCompletionSource _ended = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Lock _gate = new();
    private TaskCompletionSource? _room;
    private IOException? _failure;

    private TermiosLink(SerialDevice device, SerialAddress address, TimeSpan writeTimeout, TimeProvider time)
    {
        _device = device;
        _time = time;
        _writeTimeout = writeTimeout;
        Description = string.Create(CultureInfo.InvariantCulture, $"serial://{address.Device}?baud={address.Baud}");
        Line = new SerialLine(address.Baud);
        new Thread(Watch) { IsBackground = true, Name = Description }.Start();
    }

    public string Description { get; }

    public SerialLine? Line { get; }

    /// <summary>Opens the device exclusively.</summary>
    /// <param name="writeTimeout">Time without an accepted byte after which the link counts as lost.</param>
    /// <exception cref="ControllerLinkException">The device does not exist, it is not a serial line, or another program uses it.</exception>
    public static TermiosLink Open(SerialAddress address, TimeSpan writeTimeout, TimeProvider time) => new(SerialDevice.Open(address), address, writeTimeout, time);

    public async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        while (!bytes.IsEmpty)
        {
            cancellation.ThrowIfCancellationRequested();
            var (taken, room) = Send(bytes.Span);
            bytes = bytes[taken..];
            if (room is not null) await WaitForRoomAsync(room, cancellation).ConfigureAwait(false);
        }
    }

    public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => _received.ReadAsync(buffer, cancellation);

    public async ValueTask DrainAsync(CancellationToken cancellation)
    {
        await SerialDrain.WaitAsync(Unsent, _writeTimeout, _time, cancellation).ConfigureAwait(false);
        _device.DrainsOnClose = true;
    }

    public async ValueTask DisposeAsync()
    {
        Fail(new IOException(Wording.Get("SerialLink.Closed")));
        await _ended.Task.ConfigureAwait(false);
    }

    private int Unsent()
    {
        lock (_gate) return _failure is null ? _device.Unsent : throw new IOException(_failure.Message, _failure);
    }

    private (int Taken, Task? Room) Send(ReadOnlySpan<byte> bytes)
    {
        lock (_gate)
        {
            if (_failure is not null) throw new IOException(_failure.Message, _failure);
            var taken = _device.Write(bytes);
            if (taken > 0) return (taken, null);
            _room ??= new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
            _device.Ring();
            return (0, _room.Task);
        }
    }

    private async Task WaitForRoomAsync(Task room, CancellationToken cancellation)
    {
        try
        {
            await room.WaitAsync(_writeTimeout, _time, cancellation).ConfigureAwait(false);
        }
        catch (TimeoutException nothing)
        {
            throw SerialDrain.NothingAccepted(_writeTimeout, nothing);
        }
    }

    /// <summary>Runs on the thread: reads bytes, reports when bytes can be sent, and closes the device at the end.</summary>
    private void Watch()
    {
        try
        {
            while (TryContinue(out var toSend)) HandleEvents(_device.Wait(toSend));
        }
        catch (IOException gone)
        {
            Fail(gone);
        }

        if (_failure is { } failure) _received.End(failure);
        lock (_gate) _device.Dispose();
        _ended.TrySetResult();
    }

    private bool TryContinue(out bool toSend)
    {
        lock (_gate)
        {
            toSend = _room is not null;
            return _failure is null;
        }
    }

    /// <summary>Handles events; bytes received before a hang-up are still read.</summary>
    private void HandleEvents(short happened)
    {
        if ((happened & SerialNative.PollOut) != 0) SignalRoom(null);
        Span<byte> bytes = stackalloc byte[512];
        while ((happened & SerialNative.PollIn) != 0 && _device.Read(bytes) is > 0 and var count) _received.Add(bytes[..count]);
        if ((happened & SerialNative.PollGone) != 0) throw new IOException(Wording.Get("SerialLink.DeviceDisconnected"));
    }

    private void Fail(IOException failure)
    {
        lock (_gate)
        {
            if (_failure is not null) return;
            _failure = failure;
            _device.Ring();
        }

        SignalRoom(failure);
    }

    private void SignalRoom(IOException? failure)
    {
        TaskCompletionSource? waiting;
        lock (_gate)
        {
            waiting = _room;
            _room = null;
        }

        if (failure is null) waiting?.TrySetResult();
        else waiting?.TrySetException(failure);
    }
}
