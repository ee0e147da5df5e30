using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs.Wires;

/// <summary>Every byte that passes between a host and a controller over all handles, in order. Bytes of one handle in one direction that follow each other
/// are one block, so that the record does not depend on how a reply was divided into reads.</summary>
internal sealed class WireRecord
{
    private readonly Lock _guard = new();
    private readonly StringBuilder _text = new();
    private string _block = "";
    private int _handles;
    private int _bytes;
    private int _lines;

    /// <summary>The whole record: blocks that begin with the handle and <c>&gt;</c> sent or <c>&lt;</c> received.</summary>
    public string Text
    {
        get
        {
            lock (_guard) return _text.ToString();
        }
    }

    /// <summary>Bytes, lines sent, and SHA-256 of <see cref="Text"/>.</summary>
    public string Digest
    {
        get
        {
            lock (_guard) return string.Create(CultureInfo.InvariantCulture, $"{_bytes} bytes, {_lines} lines, {Convert.ToHexStringLower(SHA256.HashData(Encoding.Latin1.GetBytes(_text.ToString())))}");
        }
    }

    /// <summary>A link whose bytes are recorded. Handles are numbered in the order in which they are opened.</summary>
    public IControllerLink Over(IControllerLink link) => new RecordedLink(link, Interlocked.Increment(ref _handles), this);

    private void Add(int handle, char direction, ReadOnlySpan<byte> bytes)
    {
        lock (_guard)
        {
            var block = string.Create(CultureInfo.InvariantCulture, $"\n{handle}{direction} ");
            if (block != _block) _text.Append(_block = block);
            _text.Append(Encoding.Latin1.GetString(bytes).Replace('\n', '|'));
            _bytes += bytes.Length;
            if (direction == '>') _lines += bytes.Count((byte)'\r');
        }
    }

    private sealed class RecordedLink(IControllerLink link, int handle, WireRecord record) : IControllerLink
    {
        public string Description => link.Description;

        public SerialLine? Line => link.Line;

        public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
        {
            record.Add(handle, '>', bytes.Span);
            return link.WriteAsync(bytes, cancellation);
        }

        public async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation)
        {
            var count = await link.ReadAsync(buffer, cancellation);
            record.Add(handle, '<', buffer.Span[..count]);
            return count;
        }

        public ValueTask DisposeAsync() => link.DisposeAsync();
    }
}
