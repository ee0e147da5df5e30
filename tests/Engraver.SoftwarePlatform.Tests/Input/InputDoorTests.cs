using Avalonia;
using Avalonia.Input;
using Engraver.SoftwarePlatform.Input;

namespace Engraver.SoftwarePlatform.Tests.Input;

public sealed class InputDoorTests
{
    private const nint Window = 3;
    private readonly InputRegions _regions = new();
    private readonly List<KeyPress> _seen = [];

    [Fact]
    public void Held_keys_repeat_until_they_are_let_go_or_forgotten()
    {
        var door = new InputDoor(See, _regions);
        door.Admits(Key.J, KeyModifiers.None, isDown: true);
        door.Admits(Key.J, KeyModifiers.None, isDown: true);
        door.Admits(Key.J, KeyModifiers.None, isDown: false);
        door.Admits(Key.J, KeyModifiers.None, isDown: true);
        door.ForgetHeldKeys();
        door.Admits(Key.J, KeyModifiers.None, isDown: true);

        Assert.Equal([false, true, false, false, false], _seen.Select(press => press.IsRepeat));
    }

    [Fact]
    public void A_filter_s_true_swallows_the_key()
    {
        var door = new InputDoor((in KeyPress press) => press.Key == Key.Pause, _regions);

        Assert.False(door.Admits(Key.Pause, KeyModifiers.None, isDown: true));
        Assert.True(door.Admits(Key.A, KeyModifiers.None, isDown: true));
    }

    [Fact]
    public void A_filter_that_throws_lets_the_key_through()
    {
        var door = new InputDoor((in KeyPress _) => throw new InvalidOperationException("a fault in the filter"), _regions);

        Assert.True(door.Admits(Key.A, KeyModifiers.None, isDown: true));
    }

    [Fact]
    public void A_region_swallows_press_and_release_inside_it_in_its_window_only()
    {
        var door = new InputDoor(null, _regions);
        using var region = _regions.Add(Window, new Rect(10, 10, 100, 40), MouseButton.Left, () => true);

        Assert.True(door.AdmitsPress(Window, new Point(5, 5), MouseButton.Left));
        Assert.True(door.AdmitsPress(Window + 1, new Point(20, 20), MouseButton.Left));
        Assert.True(door.AdmitsPress(Window, new Point(20, 20), MouseButton.Right));
        Assert.False(door.AdmitsPress(Window, new Point(20, 20), MouseButton.Left));
        Assert.False(door.AdmitsRelease(Window, MouseButton.Left));
        Assert.True(door.AdmitsRelease(Window, MouseButton.Left));
    }

    [Fact]
    public void A_region_can_be_moved_and_taken_away()
    {
        var door = new InputDoor(null, _regions);
        var region = _regions.Add(Window, new Rect(0, 0, 10, 10), MouseButton.Left, () => true);
        region.Area = new Rect(50, 50, 10, 10);
        Assert.True(door.AdmitsPress(Window, new Point(5, 5), MouseButton.Left));
        Assert.False(door.AdmitsPress(Window, new Point(55, 55), MouseButton.Left));

        region.Dispose();
        Assert.True(door.AdmitsPress(Window, new Point(55, 55), MouseButton.Left));
    }

    private bool See(in KeyPress press)
    {
        _seen.Add(press);
        return false;
    }
}
