using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.App.Connections;

/// <summary>The sheet that asks for the controller's address. Its only result is the address with which CNCCONNECT is run.</summary>
public sealed class ConnectModel : ObservableObject
{
    private const double RealTimeSpeed = 1.0;
    private readonly DesktopModel _desk;
    private LinkKind _kind;
    private bool _isOpen;
    private string _host = "";
    private string _port = ControllerAddress.DefaultTcpPort.ToString(CultureInfo.InvariantCulture);
    private string _device = "";
    private int _baud = ControllerAddress.DefaultBaud;
    private FlowChoice _flow;
    private SerialDriver? _driver;
    private bool _isMaxSpeed;

    public ConnectModel(DesktopModel desk)
    {
        _desk = desk;
        Flows = [new(SerialFlow.RtsCts, "rtscts"), new(SerialFlow.XonXoff, "xonxoff"), new(SerialFlow.None, "none")];
        _flow = Flows[0];
        Connect = new RelayCommand(ConnectNow, () => IsAddress);
        Cancel = new RelayCommand(() => IsOpen = false);
    }

    public RelayCommand Connect { get; }

    public RelayCommand Cancel { get; }

    public IReadOnlyList<int> Bauds { get; } = [.. SerialLine.Rates];

    public IReadOnlyList<FlowChoice> Flows { get; }

    public bool IsOpen
    {
        get => _isOpen;
        private set => SetProperty(ref _isOpen, value);
    }

    public bool IsSimulated
    {
        get => _kind == LinkKind.Simulated;
        set => Choose(value, LinkKind.Simulated);
    }

    public bool IsNetwork
    {
        get => _kind == LinkKind.Network;
        set => Choose(value, LinkKind.Network);
    }

    public bool IsSerial
    {
        get => _kind == LinkKind.Serial;
        set => Choose(value, LinkKind.Serial);
    }

    /// <summary>True: the simulated controller computes its motion as fast as possible (speed max).</summary>
    public bool IsMaxSpeed
    {
        get => _isMaxSpeed;
        set => Change(ref _isMaxSpeed, value);
    }

    public string Host
    {
        get => _host;
        set => Change(ref _host, value ?? "");
    }

    public string Port
    {
        get => _port;
        set => Change(ref _port, value ?? "");
    }

    /// <summary>Device path or port name.</summary>
    public string Device
    {
        get => _device;
        set => Change(ref _device, value ?? "");
    }

    /// <summary>The serial devices of this computer when the sheet was opened.</summary>
    public IReadOnlyList<string> Devices { get; private set; } = [];

    public bool HasDevices => Devices.Count > 0;

    /// <summary>The listed device that is used; null if another one is typed.</summary>
    public string? ListedDevice
    {
        get => Devices.FirstOrDefault(device => device == Device.Trim());
        set => Device = value ?? Device;
    }

    public int Baud
    {
        get => _baud;
        set => Change(ref _baud, value);
    }

    public FlowChoice Flow
    {
        get => _flow;
        set => Change(ref _flow, value ?? Flows[0]);
    }

    /// <summary>The address that is passed to CNCCONNECT.</summary>
    public string Address => _kind switch
    {
        LinkKind.Network => $"tcp://{Host.Trim()}:{Port.Trim()}",
        LinkKind.Serial => string.Create(CultureInfo.InvariantCulture, $"serial://{Device.Trim()}?baud={Baud}&flow={Flow.Word}{SerialDrivers.OptionText(_driver)}"),
        _ => IsMaxSpeed ? "sim:?speed=max" : "sim:?speed=1",
    };

    /// <summary>The line as it would be typed at the command line, or the name of the missing value.</summary>
    public string CommandText => IsAddress ? Text.Get("Connect.CommandLine", Address) : Text.Get("Connect.AddressInvalid");

    internal Func<IReadOnlyList<string>> FindDevices { get; set; } = () => Discovery.Devices;

    private bool IsAddress => _desk.Session.Families.TryParseAddress(Address, out _);

    /// <summary>Shows the sheet as last used.</summary>
    public void Open()
    {
        if (_desk.Session.Settings.Current.LastAddress is { } last && _desk.Session.Families.TryParseAddress(last, out var address)) Load(address);
        Devices = FindDevices();
        OnPropertyChanged(null);
        Connect.RaiseCanExecuteChanged();
        IsOpen = true;
    }

    private void Load(ControllerAddress address)
    {
        switch (address)
        {
            case TcpAddress tcp:
                (_kind, _host, _port) = (LinkKind.Network, tcp.Host, tcp.Port.ToString(CultureInfo.InvariantCulture));
                break;
            case SerialAddress serial:
                (_kind, _device, _baud, _flow, _driver) = (LinkKind.Serial, serial.Device, serial.Baud, Flows.First(choice => choice.Flow == serial.Flow), serial.Driver);
                break;
            case SimulatedAddress simulated:
                (_kind, _isMaxSpeed) = (LinkKind.Simulated, simulated.HasExplicitSpeed && simulated.Speed > RealTimeSpeed);
                break;
        }
    }

    private void ConnectNow()
    {
        IsOpen = false;
        _ = _desk.Queue.RunAsync("CNCCONNECT", Address);
    }

    private void Choose(bool chosen, LinkKind kind)
    {
        if (chosen) Change(ref _kind, kind);
    }

    private void Change<T>(ref T field, T value)
    {
        if (!SetProperty(ref field, value)) return;
        OnPropertyChanged(null);
        Connect.RaiseCanExecuteChanged();
    }
}

/// <summary>A kind of flow control.</summary>
/// <param name="Word">As written in an address.</param>
public sealed record FlowChoice(SerialFlow Flow, string Word)
{
    public string Name => Text.Get("Flow." + Flow);

    public override string ToString() => Name;
}

/// <summary>The kinds of links that the sheet offers.</summary>
public enum LinkKind
{
    /// <summary>The simulated controller inside this program.</summary>
    Simulated,

    /// <summary>TCP.</summary>
    Network,

    /// <summary>RS-232.</summary>
    Serial,
}
