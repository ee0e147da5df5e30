using System.IO.Compression;
using System.Text;

namespace Engraver.Workbench.Files;

/// <summary>A text file that is compressed while it is written (gzip). Each flush of the writer makes everything before it readable, even if the program
/// crashes afterwards.</summary>
public static class CompressedText
{
    private static readonly UTF8Encoding s_utf8 = new(encoderShouldEmitUTF8Identifier: false);

    /// <summary>Creates a file, replacing an existing one.</summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static StreamWriter Create(string path) =>
        new(new GZipStream(new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.Read), CompressionLevel.Fastest), s_utf8, 1 << 14) { NewLine = "\n" };

    /// <summary>Opens a compressed file, also if it was truncated by a crash or is still being written, or a plain text file.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static StreamReader Open(string path)
    {
        var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        var isCompressed = file.ReadByte() == 0x1F && file.ReadByte() == 0x8B; // the first bytes of every gzip file (RFC 1952, 2.3.1)
        file.Position = 0;
        return new StreamReader(isCompressed ? new TruncatedStream(new GZipStream(file, CompressionMode.Decompress)) : file, s_utf8);
    }

    /// <summary>A compressed stream that ends at the first unreadable byte.</summary>
    private sealed class TruncatedStream(GZipStream inner) : Stream
    {
        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

        public override int Read(Span<byte> buffer)
        {
            try
            {
                return inner.Read(buffer);
            }
            catch (Exception torn) when (torn is InvalidDataException or EndOfStreamException)
            {
                return 0;
            }
        }

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        protected override void Dispose(bool disposing)
        {
            if (disposing) inner.Dispose();
            base.Dispose(disposing);
        }
    }
}
