using Engraver.Core.Dxf;
using Microsoft.Win32.SafeHandles;

namespace Engraver.Workbench.Files;

/// <summary>A file that is read on a thread of its own from its beginning to its end, because on some computers the system needs as long to hand over 100 MB as the reader of a drawing to understand half of them.</summary>
public sealed class ArrivingFile : IArrivingBytes, IDisposable
{
    /// <summary>Bytes from which on a thread is worth while.</summary>
    public const long Large = 16_000_000;

    private const int Piece = 1 << 20;
    private readonly object _guard = new();
    private readonly SafeFileHandle _file;
    private int _arrived;
    private string? _failure;
    private volatile bool _isAbandoned;

    /// <param name="file">Closed when all is read, or nobody waits any more.</param>
    /// <param name="length">Bytes, above 0.</param>
    internal ArrivingFile(SafeFileHandle file, int length)
    {
        (_file, Bytes) = (file, GC.AllocateUninitializedArray<byte>(length));
        _ = Task.Run(ReadAll);
    }

    public byte[] Bytes { get; }

    /// <summary>Begins to read a file; null where it is better read in one piece: it is no larger than <paramref name="large"/>, larger than an array, or a stream.</summary>
    /// <exception cref="IOException">It cannot be opened.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public static ArrivingFile? TryBegin(string path, long large = Large)
    {
        if (FileKind.IsStream(path)) return null;
        var file = File.OpenHandle(path, options: FileOptions.SequentialScan);
        var length = RandomAccess.GetLength(file);
        if (length > large && length <= Array.MaxLength) return new ArrivingFile(file, (int)length);
        file.Dispose();
        return null;
    }

    public int WaitFor(int count)
    {
        lock (_guard)
        {
            while (_arrived < count && _failure is null) Monitor.Wait(_guard);
            return _arrived >= count ? _arrived : throw new IOException(_failure);
        }
    }

    /// <summary>Nobody waits for the rest any more.</summary>
    public void Dispose() => _isAbandoned = true;

    private void ReadAll()
    {
        using (_file)
        {
            while (_arrived < Bytes.Length && !_isAbandoned)
            {
                var (count, failure) = ReadPiece();
                lock (_guard)
                {
                    (_arrived, _failure) = (_arrived + count, failure);
                    Monitor.PulseAll(_guard);
                }

                if (failure is not null) return;
            }
        }
    }

    private (int Count, string? Failure) ReadPiece()
    {
        try
        {
            var count = RandomAccess.Read(_file, Bytes.AsSpan(_arrived, Math.Min(Piece, Bytes.Length - _arrived)), _arrived);
            return (count, count > 0 ? null : Wording.Get("ArrivingFile.Shorter"));
        }
        catch (Exception failed) when (failed is IOException or UnauthorizedAccessException)
        {
            return (0, failed.Message);
        }
    }
}
