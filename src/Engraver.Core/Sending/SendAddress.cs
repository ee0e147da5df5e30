using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using Engraver.Core.Machines;

namespace Engraver.Core.Sending;

/// <summary>Destination of a program: <c>serial://DEVICE?baud=4800&amp;frame=7E1&amp;flow=xonxoff</c>. A value; opening it is the caller's task.</summary>
/// <param name="Device">Device path or port name.</param>
/// <param name="Baud">Bits per second, one of <see cref="Rates"/>.</param>
/// <param name="Frame">Coding of a character in bits.</param>
/// <param name="Flow">Flow control used by the receiver.</param>
public sealed record SendAddress(string Device, int Baud, CharacterFrame Frame, SerialFlow Flow)
{
    private const string Scheme = "serial://";
    private const int DefaultBaud = 9600;

    /// <summary>What opens the device; null for the default of the system.</summary>
    public SerialDriver? Driver { get; init; }

    /// <summary>The accepted rates, from the 110 of a teleprinter upwards.</summary>
    public static IReadOnlyList<int> Rates { get; } = [110, 300, 600, 1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200];

    /// <summary>The accepted addresses, for messages.</summary>
    public static string Forms => Wording.Get("SendAddress.Forms", string.Join(", ", Rates));

    /// <summary>Time of one character on the line: ten bits in every frame.</summary>
    public TimeSpan CharacterTime => TimeSpan.FromSeconds(10.0 / Baud);

    public static bool TryParse(string text, [NotNullWhen(true)] out SendAddress? address)
    {
        ArgumentNullException.ThrowIfNull(text);
        address = null;
        if (!text.StartsWith(Scheme, StringComparison.Ordinal)) return false;
        var (device, query) = text.IndexOf('?', StringComparison.Ordinal) is >= 0 and var mark ? (text[Scheme.Length..mark], text[(mark + 1)..]) : (text[Scheme.Length..], "");
        if (device.Length == 0) return false;
        SendAddress? read = new(device, DefaultBaud, CharacterFrame.EightNone, SerialFlow.XonXoff);
        foreach (var option in query.Split('&', StringSplitOptions.RemoveEmptyEntries)) read = read is null ? null : With(read, option);
        address = read;
        return read is not null;
    }

    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Scheme}{Device}?baud={Baud}&frame={Frame.Name()}&flow={Flow.ToString().ToLowerInvariant()}{SerialDrivers.OptionText(Driver)}");

    private static SendAddress? With(SendAddress address, string option) => option.Split('=') switch
    {
        ["flow", "none"] => address with { Flow = SerialFlow.None },
        ["flow", "xonxoff"] => address with { Flow = SerialFlow.XonXoff },
        ["flow", "rtscts"] => address with { Flow = SerialFlow.RtsCts },
        ["driver", _] => SerialDrivers.Find(option) is { } driver ? address with { Driver = driver } : null,
        ["frame", var frame] => CharacterFrames.Find(frame) is { } found ? address with { Frame = found } : null,
        ["baud", var rate] => int.TryParse(rate, NumberStyles.None, CultureInfo.InvariantCulture, out var baud) && Rates.Contains(baud) ? address with { Baud = baud } : null,
        _ => null,
    };
}
