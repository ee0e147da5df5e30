using System.Collections.Concurrent;
using System.Globalization;
using Engraver.Core.Machines;

namespace Engraver.Links.Serial;

/// <summary>A link over a serial port of the library System.IO.Ports, which is loaded with the first such link.</summary>
/// <remarks>One thread reads, one writes small pieces, and one closes; no caller waits for them longer than its own time limit. Writing and closing exclude
/// each other, because the library does not allow them at the same time. Nothing is written after the first failure.</remarks>
internal sealed class PortsLink : ISerialLink
{
    /// <summary>Maximum size of one write, in bytes.</summary>
    private const int MaxPiece = 256;

    private const int BitsPerByte = 10;

    /// <summary>A piece takes at most this part of the write time-out on the line.</summary>
    private const double PieceShare = 0.25;

    /// <summary>Closing usually takes some milliseconds. A link that is opened right after this one, as before each job, must find the device free.</summary>
    private static readonly TimeSpan s_maxCloseWait = TimeSpan.FromSeconds(0.5);

    private readonly PortsDevice _device;
    private readonly TimeProvider _time;
    private readonly TimeSpan _writeTimeout;
    private readonly int _pieceSize;
    private readonly ReceivedBytes _received = new();
    private readonly BlockingCollection<Piece> _pieces = [];
    private readonly TaskCompletionSource _failed = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly TaskCompletionSource _closed = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Lock _gate = new();
    private readonly Lock _writing = new();
    private volatile IOException? _failure;
    private volatile bool _drainsOnClose;

    private PortsLink(PortsDevice device, SerialAddress address, TimeSpan writeTimeout, TimeProvider time)
    {
        (_device, _writeTimeout, _time) = (device, writeTimeout, time);
        _pieceSize = Math.Clamp((int)(address.Baud * writeTimeout.TotalSeconds * PieceShare / BitsPerByte), 1, MaxPiece);
        Description = string.Create(CultureInfo.InvariantCulture, $"serial://{address.Device}?baud={address.Baud}");
        Line = new SerialLine(address.Baud);
        Start(Receive, "receiver");
        Start(Send, "sender");
    }

    public string Description { get; }

    public SerialLine? Line { get; }

    /// <summary>Opens the device exclusively.</summary>
    /// <param name="writeTimeout">Time without an accepted byte after which the link counts as lost.</param>
    /// <exception cref="ControllerLinkException">The device does not exist, it is not a serial line, or it is in use.</exception>
    public static PortsLink Open(SerialAddress address, TimeSpan writeTimeout, TimeProvider time) => new(PortsDevice.Open(address, writeTimeout), address, writeTimeout, time);

    public async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        while (!bytes.IsEmpty)
        {
            cancellation.ThrowIfCancellationRequested();
            var piece = Enqueue(bytes[..Math.Min(_pieceSize, bytes.Length)]);
            bytes = bytes[piece.Bytes.Length..];
            await AcceptedAsync(piece, cancellation).ConfigureAwait(false);
        }
    }

    public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => _received.ReadAsync(buffer, cancellation);

    public async ValueTask DrainAsync(CancellationToken cancellation)
    {
        await SerialDrain.WaitAsync(Unsent, _writeTimeout, _time, cancellation).ConfigureAwait(false);
        _drainsOnClose = true;
    }

    /// <summary>Closes the device, and waits for it for a short time only. A device that is not closed by then stays locked until it is.</summary>
    public async ValueTask DisposeAsync()
    {
        Fail(new IOException(Wording.Get("SerialLink.Closed")));
        try
        {
            await _closed.Task.WaitAsync(s_maxCloseWait, _time).ConfigureAwait(false);
        }
        catch (TimeoutException)
        {
            // The thread continues to close the device; until then opening it reports that it is in use.
        }
    }

    private static void Start(ThreadStart work, string name) => new Thread(work) { IsBackground = true, Name = name }.Start();

    private Piece Enqueue(ReadOnlyMemory<byte> bytes)
    {
        lock (_gate)
        {
            ThrowIfFailed();
            var piece = new Piece(bytes.ToArray(), new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously));
            _pieces.Add(piece, CancellationToken.None);
            return piece;
        }
    }

    /// <summary>Waits until the device has accepted a piece, at most for the time-out.</summary>
    private async Task AcceptedAsync(Piece piece, CancellationToken cancellation)
    {
        try
        {
            await Task.WhenAny(piece.Accepted.Task, _failed.Task).WaitAsync(_writeTimeout, _time, cancellation).ConfigureAwait(false);
        }
        catch (TimeoutException nothing)
        {
            Fail(SerialDrain.NothingAccepted(_writeTimeout, nothing));
        }

        if (!piece.Accepted.Task.IsCompleted) ThrowIfFailed();
    }

    private int Unsent()
    {
        ThrowIfFailed();
        return _device.Unsent;
    }

    private void ThrowIfFailed()
    {
        if (_failure is { } failure) throw new IOException(failure.Message, failure);
    }

    /// <summary>Runs on a thread: reads until the device fails or is closed.</summary>
    private void Receive() => UntilFailure(() =>
    {
        var bytes = new byte[512];
        while (true) _received.Add(bytes.AsSpan(0, _device.Read(bytes)));
    });

    /// <summary>Runs on a thread: writes pieces until the first failure.</summary>
    private void Send() => UntilFailure(() =>
    {
        foreach (var piece in _pieces.GetConsumingEnumerable())
        {
            lock (_writing)
            {
                ThrowIfFailed();
                _device.Write(piece.Bytes);
            }

            piece.Accepted.TrySetResult();
        }
    });

    private void UntilFailure(Action work)
    {
        try
        {
            work();
        }
        catch (IOException failure)
        {
            Fail(failure);
        }
#pragma warning disable CA1031 // The root of a thread: an unknown failure of the library is a lost link, not the end of the program.
        catch (Exception unknown)
#pragma warning restore CA1031
        {
            Fail(new IOException(unknown.Message, unknown));
        }
    }

    private void Fail(IOException failure)
    {
        lock (_gate)
        {
            if (_failure is not null) return;
            _failure = failure;
            _pieces.CompleteAdding();
        }

        _received.End(failure);
        _failed.TrySetResult();
        Start(Close, "closer");
    }

    /// <summary>Runs on a thread that is not awaited: no other one may depend on the library's return.</summary>
    private void Close()
    {
        try
        {
            if (!_drainsOnClose) UntilFailure(_device.DiscardUnsent);
            lock (_writing) UntilFailure(_device.Close);
        }
        finally
        {
            _closed.TrySetResult();
        }
    }

    /// <summary>Bytes for the device.</summary>
    private sealed record Piece(byte[] Bytes, TaskCompletionSource Accepted);
}
