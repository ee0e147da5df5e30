using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>The running number and the check sum with which each line of a journal ends: <c>,"n":17,"sum":"0f3a9c21"}</c>. The sum is the first 32 bits of
/// SHA-256 over the text before it in the line.</summary>
/// <param name="Number">From 1 in a file.</param>
/// <param name="IsTrue">The line is as it was written.</param>
internal readonly record struct JournalSeal(long Number, bool IsTrue)
{
    private const string NumberField = ",\"n\":";
    private const string SumField = ",\"sum\":\"";
    private const int SumDigits = 8;
    private const string End = "\"}";

    /// <param name="json">One object.</param>
    public static string Put(string json, long number)
    {
        var text = json[..^1] + NumberField + number.ToString(CultureInfo.InvariantCulture);
        return text + SumField + SumOf(text) + End;
    }

    /// <summary>The seal of a line; null where it has none, as in journals of older versions.</summary>
    public static JournalSeal? Of(string line)
    {
        var at = line.Length - SumField.Length - SumDigits - End.Length;
        if (at < 0 || !line.EndsWith(End, StringComparison.Ordinal) || !line.AsSpan(at).StartsWith(SumField, StringComparison.Ordinal)) return null;
        var text = line[..at];
        var number = text.LastIndexOf(NumberField, StringComparison.Ordinal);
        if (number < 0 || !long.TryParse(text.AsSpan(number + NumberField.Length), NumberStyles.None, CultureInfo.InvariantCulture, out var counted)) return null;
        return new JournalSeal(counted, line.AsSpan(at + SumField.Length, SumDigits).SequenceEqual(SumOf(text)));
    }

    private static string SumOf(string text) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text)))[..SumDigits];
}

/// <summary>Checks whether the lines of a journal are those that were written, none changed and none missing before the last. Half a line, as a crash leaves
/// it, is not counted.</summary>
internal sealed class JournalCheck
{
    private int _lines;
    private long? _number;

    /// <summary>Why the journal is not as it was written; empty while it is.</summary>
    public string Fault { get; private set; } = "";

    /// <summary>Lines of an older version, which cannot be checked.</summary>
    public bool IsUnsealed { get; private set; }

    /// <summary>Call with each line in turn.</summary>
    /// <param name="kind">Null for half a line.</param>
    public void Check(string line, string? kind)
    {
        _lines++;
        if (kind is null || Fault.Length > 0) return;
        if (JournalSeal.Of(line) is not { } seal)
        {
            if (_number is not null) Fault = Wording.Get("Resume.LineUnsealed", _lines);
            IsUnsealed = true;
            return;
        }

        if (!seal.IsTrue) Fault = Wording.Get("Resume.LineChanged", _lines);
        else if ((_number ?? (IsUnsealed ? seal.Number - 1 : 0)) + 1 != seal.Number) Fault = Wording.Get("Resume.LinesMissing", _lines, (_number ?? 0) + 1, seal.Number);
        _number = seal.Number;
    }
}
