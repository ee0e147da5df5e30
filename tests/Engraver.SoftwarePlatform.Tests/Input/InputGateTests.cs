using Avalonia;
using Avalonia.Input;
using Engraver.SoftwarePlatform.Input;

namespace Engraver.SoftwarePlatform.Tests.Input;

public sealed class InputGateTests
{
    private const nint Window = 3;
    private readonly InputRegions _regions = new();
    private readonly List<KeyPress> _seen = [];

    [Fact]
    public void Held_keys_repeat_until_they_are_let_go_or_forgotten()
    {
        var gate = new InputGate(See, _regions);
        gate.Admits(Key.J, KeyModifiers.None, isDown: true);
        gate.Admits(Key.J, KeyModifiers.None, isDown: true);
        gate.Admits(Key.J, KeyModifiers.None, isDown: false);
        gate.Admits(Key.J, KeyModifiers.None, isDown: true);
        gate.ForgetHeldKeys();
        gate.Admits(Key.J, KeyModifiers.None, isDown: true);

        Assert.Equal([false, true, false, false, false], _seen.Select(press => press.IsRepeat));
    }

    [Fact]
    public void A_filter_s_true_swallows_the_key()
    {
        var gate = new InputGate((in KeyPress press) => press.Key == Key.Pause, _regions);

        Assert.False(gate.Admits(Key.Pause, KeyModifiers.None, isDown: true));
        Assert.True(gate.Admits(Key.A, KeyModifiers.None, isDown: true));
    }

    [Fact]
    public void A_filter_that_throws_lets_the_key_through()
    {
        var gate = new InputGate((in KeyPress _) => throw new InvalidOperationException("a fault in the filter"), _regions);

        Assert.True(gate.Admits(Key.A, KeyModifiers.None, isDown: true));
    }

    [Fact]
    public void A_region_swallows_press_and_release_inside_it_in_its_window_only()
    {
        var gate = new InputGate(null, _regions);
        using var region = _regions.Add(Window, new Rect(10, 10, 100, 40), MouseButton.Left, () => true);

        Assert.True(gate.AdmitsPress(Window, new Point(5, 5), MouseButton.Left));
        Assert.True(gate.AdmitsPress(Window + 1, new Point(20, 20), MouseButton.Left));
        Assert.True(gate.AdmitsPress(Window, new Point(20, 20), MouseButton.Right));
        Assert.False(gate.AdmitsPress(Window, new Point(20, 20), MouseButton.Left));
        Assert.False(gate.AdmitsRelease(Window, MouseButton.Left));
        Assert.True(gate.AdmitsRelease(Window, MouseButton.Left));
    }

    [Fact]
    public void A_region_can_be_moved_and_taken_away()
    {
        var gate = new InputGate(null, _regions);
        var region = _regions.Add(Window, new Rect(0, 0, 10, 10), MouseButton.Left, () => true);
        region.Area = new Rect(50, 50, 10, 10);
        Assert.True(gate.AdmitsPress(Window, new Point(5, 5), MouseButton.Left));
        Assert.False(gate.AdmitsPress(Window, new Point(55, 55), MouseButton.Left));

        region.Dispose();
        Assert.True(gate.AdmitsPress(Window, new Point(55, 55), MouseButton.Left));
    }

    private bool See(in KeyPress press)
    {
        _seen.Add(press);
        return false;
    }
}
