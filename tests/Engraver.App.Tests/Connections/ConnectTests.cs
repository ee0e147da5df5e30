using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.Connections;
using Engraver.Core.Machines;
using Engraver.Simulator;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.Connections;

[Collection(DesktopCollection.Name)]
public sealed class ConnectTests(DesktopFixture fixture)
{
    [Fact]
    public Task Enter_connects_what_is_chosen() => fixture.WithOperator(here =>
    {
        Open(here);
        Assert.True(here.Find<RadioButton>("SimulatedChoice").IsChecked);
        here.Hands.Press(Key.Enter);
        here.WaitUntilIdle();

        Assert.False(here.Window.Model.Connect.IsOpen);
        Assert.Equal(MachineState.Ready, here.Commands.Machine.Status.State);
        Assert.Contains("Enter address of the controller <sim:>: sim:?speed=1", here.History.Select(line => line.Trim()));
    });

    [Fact]
    public Task Escape_leaves_everything_as_it_was() => fixture.WithOperator(here =>
    {
        Open(here);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();

        Assert.False(here.Window.Model.Connect.IsOpen);
        Assert.Equal(MachineState.Offline, here.Commands.Machine.Status.State);
        Assert.Empty(here.History);
    });

    [Fact]
    public Task A_network_controller_is_typed_in_and_remembered() => fixture.WithOperator(here =>
    {
        var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var listening = controller.ListenTcpAsync(0, CancellationToken.None);
        here.Until(() => listening.IsCompleted);
        Open(here);
        here.Click(here.Find<RadioButton>("NetworkChoice"));
        Assert.False(here.Find<Button>("ConnectButton").IsEffectivelyEnabled);
        here.Click(here.Find<TextBox>("HostBox"));
        here.Hands.Type("127.0.0.1");
        here.Window.Model.Connect.Port = FormattableString.Invariant($"{listening.Result.Port}");
        here.Click(here.Find<Button>("ConnectButton"));
        here.WaitUntilIdle();

        Assert.Equal(MachineState.Ready, here.Commands.Machine.Status.State);
        Assert.Equal("", here.Window.Model.Command.Line);
        var address = FormattableString.Invariant($"tcp://127.0.0.1:{listening.Result.Port}");
        Assert.Equal(address, here.Commands.Settings.Current.LastAddress);
        Open(here);
        Assert.True(here.Window.Model.Connect.IsNetwork);
        Assert.Equal(address, here.Window.Model.Connect.Address);
        here.Hands.Press(Key.Escape);
        here.Enter("CNCDISCONNECT");
        var ending = controller.DisposeAsync().AsTask();
        here.Until(() => ending.IsCompleted);
    });

    [Theory]
    [InlineData("serial:///dev/ttyS3?baud=57600&flow=xonxoff")]
    [InlineData("serial:///dev/ttyS0?baud=19200&flow=rtscts")]
    [InlineData("serial:///dev/ttyS0?baud=19200&flow=none&driver=ports")]
    [InlineData("tcp://10.0.0.5:5002")]
    [InlineData("sim:?speed=1")]
    [InlineData("sim:?speed=max")]
    public Task The_sheet_opens_as_it_was_used_last(string address) => fixture.WithOperator(here =>
    {
        here.Commands.Settings.Change(settings => settings with { LastAddress = address });
        Open(here);

        Assert.Equal(address, here.Window.Model.Connect.Address);
        Assert.True(here.Find<Button>("ConnectButton").IsEffectivelyEnabled);
        here.Hands.Press(Key.Escape);
    });

    [Fact]
    public Task A_device_of_the_list_is_the_device_of_the_address() => fixture.WithOperator(here =>
    {
        here.Window.Model.Connect.FindDevices = () => ["COM3", "COM10"];
        Open(here);
        here.Click(here.Find<RadioButton>("SerialChoice"));
        var list = here.Find<ComboBox>("DeviceList");
        Assert.True(list.IsEffectivelyVisible);
        Assert.Equal(["COM3", "COM10"], list.Items.Cast<string>());

        list.SelectedItem = "COM10";

        Assert.Equal("serial://COM10?baud=19200&flow=rtscts", here.Window.Model.Connect.Address);
        here.Window.Model.Connect.Device = "COM7";
        Assert.Null(here.Window.Model.Connect.ListedDevice);
        here.Hands.Press(Key.Escape);
        here.Window.Model.Connect.FindDevices = () => [];
        Open(here);
        Assert.False(list.IsVisible);
        here.Hands.Press(Key.Escape);
    });

    [Fact]
    public Task The_lists_hold_what_the_controller_can() => fixture.WithOperator(here =>
    {
        Open(here);
        here.Click(here.Find<RadioButton>("SerialChoice"));
        Assert.Equal(SerialLine.Rates, here.Find<ComboBox>("BaudList").Items.Cast<int>());
        Assert.Equal(Enum.GetValues<SerialFlow>().Order(), here.Window.Model.Connect.Flows.Select(choice => choice.Flow).Order());
        here.Window.Model.Connect.Device = "COM7";
        here.Window.Model.Connect.Flow = here.Window.Model.Connect.Flows.Single(choice => choice.Flow == SerialFlow.None);
        here.Step();

        Assert.Equal("CNCCONNECT serial://COM7?baud=19200&flow=none", here.Find<TextBlock>("TypedText").Text);
        here.Hands.Press(Key.Escape);
    });

    [Fact]
    public Task Stop_stands_free_beside_the_sheet() => fixture.WithOperator(here =>
    {
        Open(here);
        var sheet = here.Window.GetVisualDescendants().OfType<ConnectView>().Single();
        var area = new Rect(sheet.Bounds.Size).TransformToAABB(sheet.TransformToVisual(here.Window)!.Value);

        Assert.True(area.Width > 0 && here.Window.StopArea.Width >= 64, "one of them is not there");
        Assert.False(area.Intersects(here.Window.StopArea));
        here.Hands.Press(Key.Escape);
    });

    private static void Open(Operator here)
    {
        here.Click(here.Window.GetVisualDescendants().OfType<Button>().Single(button => button.Tag is "CNCCONNECT"));
        Assert.True(here.Window.Model.Connect.IsOpen);
        here.Step();
    }
}
