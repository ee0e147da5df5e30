using System.Text;

namespace Engraver.Galil.Protocol;

/// <summary>Removes the echo of a serial line (EO 1, galil-dmc.md A.2) from what is received and compares it with what was sent. It takes no time, because the line is full duplex.</summary>
/// <remarks>
/// Lines are sent one command at a time, so that an echo is complete before its reply begins. Whether the end of a line is echoed as CR, as CR LF or not at all is not known (A.2), so each is accepted.
/// A download is verified by the upload after it: its echo, if there is one, is only removed. Bytes with bit 7 set are messages (A.5) and may come in between.
/// </remarks>
internal sealed class LineEcho
{
    private const byte Return = (byte)'\r';

    private readonly List<byte> _expected = [];
    private int _heard;
    private bool _isDownload;

    /// <summary>The echo up to the first byte that differs; null while all agrees.</summary>
    public string? Harm { get; private set; }

    /// <summary>Call before a line is sent.</summary>
    public void Begin(bool isDownload)
    {
        _expected.Clear();
        (_heard, _isDownload, Harm) = (0, isDownload, null);
    }

    public void Sent(ReadOnlySpan<byte> bytes) => _expected.AddRange(bytes);

    /// <summary>Removes the echo from the received bytes, in place.</summary>
    /// <returns>Number of bytes that are left at the front of <paramref name="received"/>.</returns>
    public int Strip(Span<byte> received)
    {
        var left = 0;
        foreach (var value in received)
        {
            if (!IsEcho(value)) received[left++] = value;
        }

        return left;
    }

    private bool IsEcho(byte value)
    {
        if (value >= 0x80 || Harm is not null) return false;
        if (_heard > _expected.Count) return false;
        if (_heard == _expected.Count) return IsFeedBehindEcho(value);
        if (value == _expected[_heard])
        {
            _heard++;
            return true;
        }

        if (_isDownload) return value is not ((byte)':' or (byte)'?');
        if (_heard == _expected.Count - 1 && (value == (byte)':' || value == (byte)'\n')) // the end of the line was not echoed as it was sent
        {
            _heard = _expected.Count + 1;
            return value == (byte)'\n';
        }

        Harm = Encoding.Latin1.GetString([.. _expected.Take(_heard), value]);
        return false;
    }

    /// <summary>True for an LF directly after the CR of the echo.</summary>
    private bool IsFeedBehindEcho(byte value)
    {
        var isFeed = value == (byte)'\n' && _expected.Count > 0 && _expected[^1] == Return;
        _heard = _expected.Count + 1;
        return isFeed;
    }
}
