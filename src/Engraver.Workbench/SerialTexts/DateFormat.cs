using System.Globalization;
using System.Text;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The format of a date field. The calendar is the Gregorian one, the digits are 0 to 9, whatever the language.</summary>
public sealed record DateFormat
{
    /// <summary>The format of a field that states none.</summary>
    public const string Default = "yyyy-MM-dd";

    /// <summary>The letters and how often each of them may be repeated.</summary>
    private static readonly (char Sign, int[] Lengths)[] s_letters = [('y', [2, 4]), ('M', [1, 2]), ('d', [1, 2]), ('D', [3]), ('G', [2, 4]), ('w', [1, 2]), ('H', [1, 2]), ('m', [1, 2]), ('s', [1, 2])];

    private readonly string _format;

    private DateFormat(string format) => _format = format;

    /// <summary>The letter groups that a format may have.</summary>
    public static string Letters => string.Join(' ', s_letters.SelectMany(one => one.Lengths.Select(length => new string(one.Sign, length))));

    /// <returns>The format, or why it is not valid, without a full stop.</returns>
    public static (DateFormat? Format, string Reason) Read(string format)
    {
        ArgumentNullException.ThrowIfNull(format);
        if (format.Length == 0) return (null, Wording.Get("Serial.InvalidDateFormat", format, Letters));
        for (var at = 0; at < format.Length; at += GroupLength(format, at))
        {
            var group = format[at..(at + GroupLength(format, at))];
            if (char.IsLetter(group[0]) && !Array.Exists(s_letters, one => one.Sign == group[0] && one.Lengths.Contains(group.Length))) return (null, Wording.Get("Serial.InvalidDateFormat", group, Letters));
        }

        return (new DateFormat(format), "");
    }

    /// <summary>The characters of a date; what is not a letter in the format is copied.</summary>
    public string Of(DateTimeOffset date)
    {
        var text = new StringBuilder();
        for (var at = 0; at < _format.Length;)
        {
            var length = GroupLength(_format, at);
            text.Append(char.IsLetter(_format[at]) ? Number(ValueOf(_format[at], date), length) : _format.Substring(at, length));
            at += length;
        }

        return text.ToString();
    }

    private static int ValueOf(char letter, DateTimeOffset date) => letter switch
    {
        'y' => date.Year,
        'M' => date.Month,
        'd' => date.Day,
        'D' => date.DayOfYear,
        'G' => ISOWeek.GetYear(date.DateTime),
        'w' => ISOWeek.GetWeekOfYear(date.DateTime),
        'H' => date.Hour,
        'm' => date.Minute,
        _ => date.Second,
    };

    /// <summary>Two digits of a year are its last two.</summary>
    private static string Number(int value, int digits) => (digits == 2 ? value % 100 : value).ToString(new string('0', digits), CultureInfo.InvariantCulture);

    private static int GroupLength(string format, int at)
    {
        var end = at + 1;
        while (end < format.Length && format[end] == format[at]) end++;
        return end - at;
    }
}
