using Engraver.Core.Dxf;
using Engraver.Core.Languages;
using Microsoft.Win32.SafeHandles;

namespace Engraver.Workbench.Files;

/// <summary>A file that is read on a thread of its own from its beginning to its end, because on some computers the system needs as long to hand over 100
/// MB as the reader of a drawing to understand half of them.</summary>
public sealed class ArrivingFile : IArrivingBytes, IDisposable
{
    /// <summary>Bytes from which on a thread is worth while.</summary>
    public const long Large = 16_000_000;

    private const int Piece = 1 << 20;
    private readonly object _guard = new();
    private readonly IDisposable _file;
    private readonly Func<byte[], int, int> _read;
    private int _arrived;
    private string? _failure;

    /// <param name="file">Closed when all is read, or nobody waits any more.</param>
    /// <param name="length">Bytes, above 0.</param>
    internal ArrivingFile(SafeFileHandle file, int length)
        : this(file, length, (bytes, at) => RandomAccess.Read(file, bytes.AsSpan(at, Math.Min(Piece, bytes.Length - at)), at))
    {
    }

    /// <param name="read">Reads some bytes into an array at a place and says how many; 0 is the end.</param>
    internal ArrivingFile(IDisposable file, int length, Func<byte[], int, int> read)
    {
        (_file, _read, Bytes) = (file, read, GC.AllocateUninitializedArray<byte>(length));
        _ = Task.Factory.StartNew(ReadAll, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    public byte[] Bytes { get; }

    /// <summary>Begins to read a file; null where it is better read in one piece: it is no larger than <paramref name="large"/>, larger than an array, or a
    /// stream.</summary>
    /// <exception cref="IOException">It cannot be opened.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public static ArrivingFile? TryBegin(string path, long large = Large)
    {
        if (FileKind.IsStream(path)) return null;
        var file = File.OpenHandle(path, options: FileOptions.SequentialScan);
        var begun = false;
        try
        {
            var length = RandomAccess.GetLength(file);
            if (length <= large || length > Array.MaxLength) return null;
            var arriving = new ArrivingFile(file, (int)length);
            begun = true;
            return arriving;
        }
        finally
        {
            if (!begun) file.Dispose();
        }
    }

    public int WaitFor(int count)
    {
        lock (_guard)
        {
            while (_arrived < count && _failure is null) Monitor.Wait(_guard);
            return _arrived >= count ? _arrived : throw new IOException(_failure);
        }
    }

    /// <summary>The rest is not wanted any more: who waits for it on another thread is told that it was not read.</summary>
    public void Dispose() => Tell(0, Wording.Get("ArrivingFile.NotRead"));

    private bool IsWanted
    {
        get
        {
            lock (_guard) return _failure is null;
        }
    }

    /// <summary>The file is closed before its last byte or its failure is told.</summary>
    private void ReadAll()
    {
        var (at, last, failure) = (0, 0, default(string));
        try
        {
            do
            {
                Tell(last, null);
                (last, failure) = (0, Wording.Get("ArrivingFile.NotRead")); // where reading fails in a way that is not expected
                (last, failure) = ReadPiece(at);
                at += last;
            }
            while (failure is null && at < Bytes.Length && IsWanted);
        }
        finally
        {
            _file.Dispose();
            Tell(last, failure);
        }
    }

    private void Tell(int more, string? failure)
    {
        lock (_guard)
        {
            _arrived += more;
            _failure ??= failure;
            Monitor.PulseAll(_guard);
        }
    }

    private (int Count, string? Failure) ReadPiece(int at)
    {
        try
        {
            var count = _read(Bytes, at);
            return (count, count > 0 ? null : Wording.Get("ArrivingFile.BecameShorter"));
        }
        catch (Exception failed) when (failed is IOException or UnauthorizedAccessException)
        {
            return (0, SystemReason.Of(failed));
        }
    }
}
