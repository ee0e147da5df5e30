using Engraver.Core.Dxf;
using Engraver.Core.Languages;
using Microsoft.Win32.SafeHandles;

namespace Engraver.Workbench.Files;

/// <summary>A file that is read sequentially on a separate thread, because on some computers reading 100 MB takes as long as parsing half of it.</summary>
public sealed class ProgressiveFile : IProgressiveBytes, IDisposable
{
    /// <summary>Minimum file size in bytes for a separate thread.</summary>
    public const long MinProgressiveLength = 16_000_000;

    private const int ChunkSize = 1 << 20;
    private readonly object _guard = new();
    private readonly IDisposable _file;
    private readonly Func<byte[], int, int> _read;
    private int _arrived;
    private string? _failure;

    /// <param name="file">Closed when everything is read or on dispose.</param>
    /// <param name="length">Bytes, above 0.</param>
    internal ProgressiveFile(SafeFileHandle file, int length)
        : this(file, length, (bytes, at) => RandomAccess.Read(file, bytes.AsSpan(at, Math.Min(ChunkSize, bytes.Length - at)), at))
    {
    }

    /// <param name="read">Reads bytes into an array at an offset and returns their number; 0 is the end.</param>
    internal ProgressiveFile(IDisposable file, int length, Func<byte[], int, int> read)
    {
        (_file, _read, Bytes) = (file, read, GC.AllocateUninitializedArray<byte>(length));
        _ = Task.Factory.StartNew(ReadAll, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    public byte[] Bytes { get; }

    /// <summary>Starts reading a file; null if the file should be read at once: it is not larger than <paramref name="large"/>, larger than an array, or a
    /// stream.</summary>
    /// <exception cref="IOException">It cannot be opened.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static ProgressiveFile? TryStart(string path, long large = MinProgressiveLength)
    {
        if (FileKind.IsStream(path)) return null;
        var file = File.OpenHandle(path, options: FileOptions.SequentialScan);
        var begun = false;
        try
        {
            var length = RandomAccess.GetLength(file);
            if (length <= large || length > Array.MaxLength) return null;
            var arriving = new ProgressiveFile(file, (int)length);
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

    /// <summary>Stops reading: a waiting thread receives a failure.</summary>
    public void Dispose() => ReportProgress(0, Wording.Get("ProgressiveFile.NotRead"));

    private bool IsWanted
    {
        get
        {
            lock (_guard) return _failure is null;
        }
    }

    /// <summary>The file is closed before its last byte or its failure is reported.</summary>
    private void ReadAll()
    {
        var (at, last, failure) = (0, 0, default(string));
        try
        {
            do
            {
                ReportProgress(last, null);
                (last, failure) = (0, Wording.Get("ProgressiveFile.NotRead")); // An unexpected failure while reading.
                (last, failure) = ReadChunk(at);
                at += last;
            }
            while (failure is null && at < Bytes.Length && IsWanted);
        }
        finally
        {
            _file.Dispose();
            ReportProgress(last, failure);
        }
    }

    private void ReportProgress(int more, string? failure)
    {
        lock (_guard)
        {
            _arrived += more;
            _failure ??= failure;
            Monitor.PulseAll(_guard);
        }
    }

    private (int Count, string? Failure) ReadChunk(int at)
    {
        try
        {
            var count = _read(Bytes, at);
            return (count, count > 0 ? null : Wording.Get("ProgressiveFile.BecameShorter"));
        }
        catch (Exception failed) when (failed is IOException or UnauthorizedAccessException)
        {
            return (0, SystemErrorText.FromException(failed));
        }
    }
}
