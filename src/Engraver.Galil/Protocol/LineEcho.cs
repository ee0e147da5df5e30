using System.Text;

namespace Engraver.Galil.Protocol;

/// <summary>Takes the echo of a serial line (EO 1, galil-dmc.md A.2) out of what comes back and compares it with what was sent. Full duplex: it costs no time.</summary>
/// <remarks>
/// Lines go out one command at a time, so that an echo is whole before its reply begins. Whether the end of a line comes back as CR, as CR LF or not at all is not settled (A.2), so each is taken.
/// A download is compared by the upload behind it: here its echo, if there is one, is passed over. Bytes with bit 7 set are messages (A.5) and come in between.
/// </remarks>
internal sealed class LineEcho
{
    private const byte Return = (byte)'\r';

    private readonly List<byte> _expected = [];
    private int _heard;
    private bool _isDownload;

    /// <summary>What came instead of what was sent, up to the first other byte; null while all agrees.</summary>
    public string? Harm { get; private set; }

    /// <summary>A line is about to be sent.</summary>
    public void Begin(bool isDownload)
    {
        _expected.Clear();
        (_heard, _isDownload, Harm) = (0, isDownload, null);
    }

    public void Sent(ReadOnlySpan<byte> bytes) => _expected.AddRange(bytes);

    /// <summary>Takes the echo out, in place.</summary>
    /// <returns>Bytes that are left at the front of <paramref name="received"/>.</returns>
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

    /// <summary>LF directly behind the CR of the echo.</summary>
    private bool IsFeedBehindEcho(byte value)
    {
        var isFeed = value == (byte)'\n' && _expected.Count > 0 && _expected[^1] == Return;
        _heard = _expected.Count + 1;
        return isFeed;
    }
}
