using System.IO.Ports;
using Engraver.Core.Machines;
using Microsoft.Win32.SafeHandles;

namespace Engraver.Links.Serial;

/// <summary>An open serial port of the library System.IO.Ports. Its methods block the calling thread; on a device that is gone they may never return.</summary>
internal sealed class PortsDevice
{
    private readonly SerialPort _port;
    private readonly Stream _stream;
    private readonly SafeFileHandle? _lock;
    private readonly TimeSpan _writeTimeout;

    private PortsDevice(SerialPort port, SafeFileHandle? claim, TimeSpan writeTimeout) => (_port, _stream, _lock, _writeTimeout) = (port, port.BaseStream, claim, writeTimeout);

    /// <summary>The names of the serial ports of this computer.</summary>
    public static IReadOnlyList<string> Names => SerialPort.GetPortNames();

    /// <summary>Number of accepted bytes that are not sent yet.</summary>
    /// <exception cref="IOException">The device was removed or closed.</exception>
    public int Unsent => Attempt(() => _port.BytesToWrite);

    /// <summary>Opens the device exclusively and sets the line. Bytes that another program left unread are dropped.</summary>
    /// <exception cref="ControllerLinkException">The device does not exist, it is not a serial line, or it is in use.</exception>
    public static PortsDevice Open(SerialAddress address, TimeSpan writeTimeout)
    {
        var claim = OperatingSystem.IsLinux() ? SerialFile.OpenLocked(address, "PortsDevice.InUse") : null; // on Linux the library does not exclude the other driver
        var port = new SerialPort(address.Device, address.Baud, Parity.None, 8, StopBits.One)
        {
            Handshake = HandshakeOf(address.Flow),
            ReadTimeout = SerialPort.InfiniteTimeout,
            WriteTimeout = (int)Math.Clamp(writeTimeout.TotalMilliseconds, 1, int.MaxValue),
        };
        try
        {
            port.Open();
            RaiseLines(port, address.Flow);
            port.DiscardInBuffer();
            return new PortsDevice(port, claim, writeTimeout);
        }
        catch (Exception refused) when (IsFailure(refused) || refused is DllNotFoundException)
        {
            port.Dispose();
            claim?.Dispose();
            throw new ControllerLinkException(WhyRefused(address, refused), refused);
        }
    }

    /// <summary>Waits for bytes.</summary>
    /// <returns>The number of bytes read, at least 1.</returns>
    /// <exception cref="IOException">The device was removed or closed.</exception>
    public int Read(byte[] bytes) => Attempt(() => _stream.Read(bytes, 0, bytes.Length)) is > 0 and var count ? count : throw Gone(null);

    /// <summary>Writes bytes; waits until the device has accepted them.</summary>
    /// <exception cref="IOException">The device was removed, or did not accept them within the time-out.</exception>
    public void Write(byte[] bytes) => Attempt(() =>
    {
        _stream.Write(bytes, 0, bytes.Length);
        return bytes.Length;
    });

    /// <summary>Drops the unsent bytes. A write that waits then ends, and closing does not wait for them.</summary>
    /// <exception cref="IOException">The device was removed or closed.</exception>
    public void DiscardUnsent() => Attempt(() =>
    {
        _port.DiscardOutBuffer();
        return true;
    });

    /// <summary>Closes the stream and not the port, which would first wait, for ever if need be, until the other side has read everything.</summary>
    /// <exception cref="IOException">The device was removed.</exception>
    public void Close()
    {
        try
        {
            Attempt(() =>
            {
                _stream.Dispose();
                _port.Dispose();
                return true;
            });
        }
        finally
        {
            _lock?.Dispose();
        }
    }

    private static Handshake HandshakeOf(SerialFlow flow) => flow switch
    {
        SerialFlow.RtsCts => Handshake.RequestToSend,
        SerialFlow.XonXoff => Handshake.XOnXOff,
        _ => Handshake.None,
    };

    /// <summary>Raises DTR and RTS, as the system does when a device is opened: the library lowers them, and a controller behind a full cable sends only while
    /// RTS is raised.</summary>
    private static void RaiseLines(SerialPort port, SerialFlow flow)
    {
        try
        {
            port.DtrEnable = true;
            if (flow != SerialFlow.RtsCts) port.RtsEnable = true;
        }
        catch (IOException)
        {
            // A pseudo-terminal has no such lines.
        }
    }

    /// <summary>The exceptions with which the library reports a device that is gone, busy, closed or unknown. <see cref="ObjectDisposedException"/> is among
    /// them.</summary>
    private static bool IsFailure(Exception failure) =>
        failure is IOException or TimeoutException or InvalidOperationException or UnauthorizedAccessException or ArgumentException or OperationCanceledException;

    /// <summary>Windows reports a device in use as denied access; elsewhere the inner exception has the system's reason.</summary>
    private static string WhyRefused(SerialAddress address, Exception refused) => refused is UnauthorizedAccessException { InnerException: null }
        ? Wording.Get("PortsDevice.InUse", address.Device)
        : Wording.Get("SerialDevice.NoConnection", address.Device, Wording.Get("SerialDevice.CannotBeOpened"), (refused.InnerException ?? refused).Message.TrimEnd('.'));

    private static IOException Gone(Exception? cause) => new(Wording.Get("SerialLink.DeviceDisconnected"), cause);

    private T Attempt<T>(Func<T> call)
    {
        try
        {
            return call();
        }
        catch (TimeoutException nothing)
        {
            throw SerialDrain.NothingAccepted(_writeTimeout, nothing);
        }
        catch (Exception gone) when (IsFailure(gone))
        {
            throw Gone(gone);
        }
    }
}
