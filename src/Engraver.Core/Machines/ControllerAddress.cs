using System.Diagnostics.CodeAnalysis;
using System.Globalization;

namespace Engraver.Core.Machines;

/// <summary>The address of a controller. Common forms: <c>tcp://HOST:PORT</c>, <c>serial://DEVICE?baud=19200</c> and <c>sim:?speed=max</c>. The scheme may be
/// omitted where the rest determines it (<c>192.168.0.2</c>, <c>COM3</c>, <c>sim</c>). An immutable value; the caller opens it. A controller family can have
/// forms of its own, which derive from this.</summary>
public abstract record ControllerAddress
{
    /// <summary>Port 23 is the convention of Galil's own hosts (galil-dmc.md A.1).</summary>
    public const int DefaultTcpPort = 23;

    /// <summary>The controller's rate without a jumper (galil-dmc.md A.2).</summary>
    public const int DefaultBaud = 19200;

    private const string TcpScheme = "tcp://";
    private const string SerialScheme = "serial://";

    /// <summary>The accepted forms, for messages.</summary>
    public static string Forms => Wording.Get("ControllerAddress.Forms");

    /// <summary>Loopback port at which a simulated controller in another process offers its clock; null for a controller that follows the wall clock.</summary>
    public int? ClockPort { get; init; }

    /// <summary>The address as typed, without a clock.</summary>
    public abstract string Typed { get; }

    /// <summary>The message for a text that is not an address.</summary>
    /// <param name="forms">The accepted forms.</param>
    public static string NotAnAddress(string text, string forms) => SerialDrivers.UnknownIn(text) is { } driver
        ? Wording.Get("ControllerAddress.UnknownDriver", text, driver, SerialDrivers.Names)
        : Wording.Get("ControllerAddress.NotAnAddress", text, forms);

    /// <exception cref="FormatException">The text is not an address; the message states what is accepted.</exception>
    public static ControllerAddress Parse(string text) =>
        TryParse(text, out var address) ? address : throw new FormatException(NotAnAddress(text, Forms));

    public static bool TryParse(string text, [NotNullWhen(true)] out ControllerAddress? address)
    {
        ArgumentNullException.ThrowIfNull(text);
        var (body, query) = Split(text.Trim());
        address = body switch
        {
            _ when body.StartsWith(TcpScheme, StringComparison.OrdinalIgnoreCase) => Tcp(body[TcpScheme.Length..], query),
            _ when body.StartsWith(SerialScheme, StringComparison.OrdinalIgnoreCase) => Serial(body[SerialScheme.Length..], query),
            _ when body.Equals("sim:", StringComparison.OrdinalIgnoreCase) || body.Equals("sim", StringComparison.OrdinalIgnoreCase) => Simulated(query),
            _ when IsPort(body) => Serial(body, query),
            _ when IsHost(body) => Tcp(body, query),
            _ => null,
        };
        return address is not null;
    }

    /// <summary>COM3, or a device path.</summary>
    private static bool IsPort(string body) =>
        body.StartsWith("/dev/", StringComparison.Ordinal) || (body.StartsWith("COM", StringComparison.OrdinalIgnoreCase) && int.TryParse(body.AsSpan(3), NumberStyles.None, CultureInfo.InvariantCulture, out var port) && port is > 0 and <= 256);

    /// <summary>An IP address or a name with a dot, also with a port. A single word is not accepted because it may be a misspelled scheme.</summary>
    private static bool IsHost(string body) =>
        !body.Contains("//", StringComparison.Ordinal) && (body.Contains('.', StringComparison.Ordinal) || body.StartsWith('[') || body.Split(':')[0] == "localhost");

    private static (string Body, string Query) Split(string text) =>
        text.IndexOf('?', StringComparison.Ordinal) is >= 0 and var mark ? (text[..mark], text[(mark + 1)..]) : (text, "");

    private static TcpAddress? Tcp(string authority, string query)
    {
        if (query.Length > 0 && Clock(query) is null) return null;
        if (!Uri.TryCreate("tcp://" + authority, UriKind.Absolute, out var uri) || uri.Host.Length == 0 || uri.AbsolutePath.Length > 1) return null;
        return uri.Port == 0 ? null : new TcpAddress(uri.Host, uri.Port < 0 ? DefaultTcpPort : uri.Port) { ClockPort = Clock(query) };
    }

    private static int? Clock(string option) =>
        option.StartsWith("clock=", StringComparison.Ordinal) && int.TryParse(option.AsSpan(6), NumberStyles.None, CultureInfo.InvariantCulture, out var port) && port is > 0 and <= 65535 ? port : null;

    private static SerialAddress? Serial(string device, string query)
    {
        if (device.Length == 0) return null;
        var address = new SerialAddress(device, DefaultBaud);
        foreach (var option in query.Split('&', StringSplitOptions.RemoveEmptyEntries))
        {
            if (With(address, option) is not { } changed) return null;
            address = changed;
        }

        return address;
    }

    private static SerialAddress? With(SerialAddress address, string option) => option switch
    {
        "flow=none" => address with { Flow = SerialFlow.None },
        "flow=xonxoff" => address with { Flow = SerialFlow.XonXoff },
        "flow=rtscts" => address with { Flow = SerialFlow.RtsCts },
        _ when SerialDrivers.Find(option) is { } driver => address with { Driver = driver },
        _ when Clock(option) is { } port => address with { ClockPort = port },
        _ => option.StartsWith("baud=", StringComparison.Ordinal)
            && int.TryParse(option.AsSpan(5), NumberStyles.None, CultureInfo.InvariantCulture, out var baud) && SerialLine.Rates.Contains(baud)
            ? address with { Baud = baud }
            : null,
    };

    private static SimulatedAddress? Simulated(string query)
    {
        if (query.Length == 0 || query == "speed=max") return new SimulatedAddress(double.PositiveInfinity) { HasExplicitSpeed = query.Length > 0 };
        return query.StartsWith("speed=", StringComparison.Ordinal)
            && double.TryParse(query.AsSpan(6), NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var speed) && speed > 0 && double.IsFinite(speed)
            ? new SimulatedAddress(speed)
            : null;
    }
}
