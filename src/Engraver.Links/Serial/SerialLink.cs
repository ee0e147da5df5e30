using System.Runtime.InteropServices;
using Engraver.Core.Machines;

namespace Engraver.Links.Serial;

/// <summary>Opens links over serial lines (galil-dmc.md A.2: 8 data bits, no parity, 1 stop bit) with the driver of the address, by default
/// <see cref="SerialDriver.Own"/> on Linux and <see cref="SerialDriver.Ports"/> on Windows and macOS.</summary>
public static class SerialLink
{
    private static bool HasOwn => OperatingSystem.IsLinux() && RuntimeInformation.ProcessArchitecture != Architecture.Ppc64le;

    /// <summary>The library has no native part for other processors of Linux.</summary>
    private static bool HasPorts => OperatingSystem.IsWindows() || OperatingSystem.IsMacOS()
        || (OperatingSystem.IsLinux() && RuntimeInformation.ProcessArchitecture is Architecture.X64 or Architecture.Arm64 or Architecture.Arm);

    /// <summary>A sentence that states why the address cannot be opened on this computer; null if it can.</summary>
    public static string? WhyUnsupported(SerialAddress address) => WhyUnsupported(address, HasOwn, HasPorts);

    /// <summary>The same for a system that has some of the drivers.</summary>
    internal static string? WhyUnsupported(SerialAddress address, bool hasOwn, bool hasPorts)
    {
        ArgumentNullException.ThrowIfNull(address);
        return (address.Driver, DriverOf(address, hasOwn)) switch
        {
            (_, SerialDriver.Own) when hasOwn => null,
            (_, SerialDriver.Ports) when hasPorts => null,
            (SerialDriver.Own, _) => Wording.Get("SerialLink.OwnUnsupported", address.Device),
            (SerialDriver.Ports, _) => Wording.Get("SerialLink.PortsUnsupported", address.Device),
            _ => Wording.Get("SerialLink.Unsupported"),
        };
    }

    /// <summary>Opens the device exclusively.</summary>
    /// <param name="writeTimeout">Time without an accepted byte after which the link counts as lost.</param>
    /// <exception cref="ControllerLinkException">The device does not exist, it is not a serial line, or another program uses it.</exception>
    /// <exception cref="PlatformNotSupportedException">See <see cref="WhyUnsupported(SerialAddress)"/>.</exception>
    public static ISerialLink Open(SerialAddress address, TimeSpan writeTimeout, TimeProvider time)
    {
        ArgumentNullException.ThrowIfNull(address);
        ArgumentNullException.ThrowIfNull(time);
        if (!SerialSettings.IsSupported(address.Baud)) throw new ArgumentOutOfRangeException(nameof(address), address.Baud, "no rate of a serial line");
        if (WhyUnsupported(address) is { } why) throw new PlatformNotSupportedException(why);
        return DriverOf(address, HasOwn) == SerialDriver.Own ? TermiosLink.Open(address, writeTimeout, time) : PortsLink.Open(address, writeTimeout, time);
    }

    private static SerialDriver DriverOf(SerialAddress address, bool hasOwn) => address.Driver ?? (hasOwn ? SerialDriver.Own : SerialDriver.Ports);
}
