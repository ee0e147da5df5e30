using System.Text;

namespace Engraver.Galil.Protocol;

/// <summary>Removes the echo of a serial line (EO 1, galil-dmc.md A.2) from the received bytes and compares it with the sent bytes. It takes no time, because
/// the line is full duplex.</summary>
/// <remarks> Lines are sent one command at a time, so that an echo is complete before its reply starts. The statements of a line that goes out whole are
/// answered by prompts alone: a prompt may come at any place after the echo of the separator that ends its statement, and nothing but prompts comes besides
/// the echo. Whether the end of a line is echoed as CR, as CR LF or not at all is not known (A.2), so each is accepted. A download is verified by the upload
/// after it; its echo, if any, is only removed. Bytes with bit 7 set are messages (A.5) and may come in between. An urgent line is sent while another waits
/// for its reply: whether its echo comes after that reply, before it or within it is not known (A.2), so each is accepted if the bytes can be distinguished.
/// Thread-safe, because an urgent line is sent by another thread than the reader's. </remarks>
/// <param name="hasLineEnd">The end of a line is echoed, as CR, LF or both.</param>
internal sealed class LineEcho(bool hasLineEnd)
{
    private const byte Return = (byte)'\r';
    private const byte Feed = (byte)'\n';
    private const byte Separator = (byte)';';

    private readonly Lock _gate = new();
    private readonly List<byte> _expected = [];
    private readonly List<byte> _urgent = [];
    private int _received;
    private int _urgentReceived;
    private bool _isDownload;
    private bool _wasUrgentReturn;
    private int _statements;
    private int _prompts;
    private int _late;

    /// <summary>The echo up to the first byte that differs; null while all bytes agree.</summary>
    public string? Difference { get; private set; }

    /// <summary>The same for an urgent line. If a reply is mixed with its echo, neither can be distinguished.</summary>
    public string? UrgentDifference { get; private set; }

    /// <summary>All characters of the line have been echoed.</summary>
    public bool IsComplete
    {
        get
        {
            lock (_gate) return _received >= _expected.Count - (hasLineEnd ? 0 : 1);
        }
    }

    /// <summary>Call before a line is sent.</summary>
    /// <param name="prompts">Those that may come before the end of its echo.</param>
    public void Begin(bool isDownload, EarlyPrompts prompts = default)
    {
        lock (_gate)
        {
            _expected.Clear();
            _urgent.Clear();
            (_received, _urgentReceived, _isDownload, _wasUrgentReturn, Difference, UrgentDifference) = (0, 0, isDownload, false, null, null);
            (_statements, _late, _prompts) = (prompts.Statements, prompts.Late, 0);
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
        if (IsEarlyPrompt(value)) return false;
        if (_received >= _expected.Count) return (_received == _expected.Count && IsFeedBehindEcho(value)) || IsAfterEcho(value);
        if (value == _expected[_received])
        {
            _received++;
            return true;
        }

        if (_isDownload) return !IsPrompt(value);
        if (_received == _expected.Count - 1 && (value == Feed || !hasLineEnd))
        {
            _received = _expected.Count + 1;
            return value == Feed || IsAfterEcho(value);
        }

        Differ(value);
        return false;
    }

    private void Differ(byte value) => Difference = Encoding.Latin1.GetString([.. _expected.Take(_received), value]);

    /// <summary>True for a prompt before the end of the echo: of a statement of this line whose separator was echoed, or a late one of the line
    /// before.</summary>
    private bool IsEarlyPrompt(byte value)
    {
        if (!IsPrompt(value) || _received >= _expected.Count) return false;
        if (_late > 0)
        {
            _late--;
            return true;
        }

        if (_prompts >= _statements) return false;
        if (_prompts < _expected.Take(_received).Count(echoed => echoed == Separator)) _prompts++;
        else if (!hasLineEnd && _received == _expected.Count - 1 && _prompts == _statements - 1) (_received, _prompts) = (_expected.Count + 1, _statements);
        else return false;
        return true;
    }

    /// <summary>True for the echo of an urgent line. After the echo of a line that went out whole only the rest of its prompts may come besides,
    /// and those of urgent lines.</summary>
    private bool IsAfterEcho(byte value)
    {
        if (IsUrgentEcho(value)) return true;
        var isTooMany = IsPrompt(value) && ++_prompts > _statements + UrgentStatements;
        if (_statements > 0 && UrgentDifference is null && (isTooMany || (_prompts < _statements && !IsPrompt(value)))) Differ(value);
        return false;
    }

    private int UrgentStatements => _urgent.Count(sent => sent is Separator or Return);

    private static bool IsPrompt(byte value) => value is (byte)':' or (byte)'?';

    /// <summary>True for an LF directly after the CR of the echo.</summary>
    private bool IsFeedBehindEcho(byte value)
    {
        var isFeed = value == Feed && _expected.Count > 0 && _expected[^1] == Return;
        _received = _expected.Count + 1;
        return isFeed;
    }

    private bool IsUrgentEcho(byte value)
    {
        var isFeed = value == Feed && _wasUrgentReturn;
        _wasUrgentReturn = false;
        if (isFeed || IsPrompt(value)) return isFeed;
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

/// <summary>The prompts that may come before the echo of a line is complete; by default none.</summary>
/// <param name="Statements">The statements of the line, where each is answered by a prompt alone; 0 for another line.</param>
/// <param name="Late">The most prompts of the line before that may still come.</param>
internal readonly record struct EarlyPrompts(int Statements, int Late);
