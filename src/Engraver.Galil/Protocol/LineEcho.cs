using System.Text;

namespace Engraver.Galil.Protocol;

/// <summary>Removes the echo of a serial line (EO 1, galil-dmc.md A.2) from the received bytes and compares it with the sent bytes. It takes no time, because
/// the line is full duplex.</summary>
/// <remarks> Lines are sent one command at a time, so that an echo is complete before its reply starts. Whether the end of a line is echoed as CR, as CR LF or
/// not at all is not known (A.2), so each is accepted. A download is verified by the upload after it; its echo, if any, is only removed. Bytes with bit 7 set
/// are messages (A.5) and may come in between. An urgent line is sent while another waits for its reply: whether its echo comes after that reply, before it or
/// within it is not known (A.2), so each is accepted if the bytes can be distinguished. Thread-safe, because an urgent line is sent by another thread than the
/// reader's. </remarks>
internal sealed class LineEcho
{
    private const byte Return = (byte)'\r';
    private const byte Feed = (byte)'\n';

    private readonly Lock _gate = new();
    private readonly List<byte> _expected = [];
    private readonly List<byte> _urgent = [];
    private int _received;
    private int _urgentReceived;
    private bool _isDownload;
    private bool _wasUrgentReturn;

    /// <summary>The echo up to the first byte that differs; null while all bytes agree.</summary>
    public string? Difference { get; private set; }

    /// <summary>The same for an urgent line. If a reply is mixed with its echo, neither can be distinguished.</summary>
    public string? UrgentDifference { get; private set; }

    /// <summary>Call before a line is sent.</summary>
    public void Begin(bool isDownload)
    {
        lock (_gate)
        {
            _expected.Clear();
            _urgent.Clear();
            (_received, _urgentReceived, _isDownload, _wasUrgentReturn, Difference, UrgentDifference) = (0, 0, isDownload, false, null, null);
        }
    }

    public void Sent(ReadOnlySpan<byte> bytes)
    {
        lock (_gate) _expected.AddRange(bytes);
    }

    /// <summary>Call when an urgent line is sent after other bytes: its commands are answered by prompts only, so that a prompt within its echo is not part of
    /// the echo.</summary>
    public void SentUrgently(ReadOnlySpan<byte> bytes)
    {
        lock (_gate) _urgent.AddRange(bytes);
    }

    /// <summary>Removes the echo from the received bytes, in place.</summary>
    /// <returns>Number of remaining bytes at the front of <paramref name="received"/>.</returns>
    public int Strip(Span<byte> received)
    {
        lock (_gate)
        {
            var left = 0;
            foreach (var value in received)
            {
                if (!IsEcho(value)) received[left++] = value;
            }

            return left;
        }
    }

    private bool IsEcho(byte value)
    {
        if (value >= 0x80 || Difference is not null || UrgentDifference is not null) return false;
        if (_received > _expected.Count) return IsUrgentEcho(value);
        if (_received == _expected.Count) return IsFeedBehindEcho(value) || IsUrgentEcho(value);
        if (value == _expected[_received])
        {
            _received++;
            return true;
        }

        if (_isDownload) return value is not ((byte)':' or (byte)'?');
        if (_received == _expected.Count - 1 && (value is (byte)':' or Feed || IsUrgentBeginning(value))) // the end of the line was echoed differently
        {
            _received = _expected.Count + 1;
            return value == Feed || IsUrgentEcho(value);
        }

        Difference = Encoding.Latin1.GetString([.. _expected.Take(_received), value]);
        return false;
    }

    /// <summary>True for an LF directly after the CR of the echo.</summary>
    private bool IsFeedBehindEcho(byte value)
    {
        var isFeed = value == Feed && _expected.Count > 0 && _expected[^1] == Return;
        _received = _expected.Count + 1;
        return isFeed;
    }

    private bool IsUrgentBeginning(byte value) => _urgentReceived == 0 && _urgent.Count > 0 && value == _urgent[0];

    private bool IsUrgentEcho(byte value)
    {
        var isFeed = value == Feed && _wasUrgentReturn;
        _wasUrgentReturn = false;
        if (isFeed || value is (byte)':' or (byte)'?') return isFeed;
        if (_urgentReceived < _urgent.Count && value == _urgent[_urgentReceived])
        {
            _wasUrgentReturn = _urgent[_urgentReceived++] == Return;
            return true;
        }

        if (_urgentReceived == 0) return false; // the overtaken reply, or no urgent line
        if (_urgent[_urgentReceived - 1] == Return || _urgent[_urgentReceived] == Return) return false; // the reply after the complete echo
        UrgentDifference = Encoding.Latin1.GetString([.. _urgent.Take(_urgentReceived), value]);
        return false;
    }
}
