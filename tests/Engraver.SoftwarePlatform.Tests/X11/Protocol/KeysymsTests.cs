using Avalonia.Input;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.Tests.X11.Protocol;

public sealed class KeysymsTests
{
    [Theory]
    [InlineData('a', Key.A)]
    [InlineData('Z', Key.Z)]
    [InlineData('7', Key.D7)]
    [InlineData(' ', Key.Space)]
    [InlineData(',', Key.OemComma)]
    [InlineData(0xFF13, Key.Pause)]
    [InlineData(0xFF6B, Key.Pause)] // Break is Control+Pause
    [InlineData(0xFF1B, Key.Escape)]
    [InlineData(0xFF0D, Key.Enter)]
    [InlineData(0xFF8D, Key.Enter)]
    [InlineData(0xFE20, Key.Tab)]
    [InlineData(0xFFBE, Key.F1)]
    [InlineData(0xFFC9, Key.F12)]
    [InlineData(0xFFB5, Key.NumPad5)]
    [InlineData(0xFF95, Key.Home)]
    [InlineData(0xFF9F, Key.Delete)]
    [InlineData(0xFFAE, Key.Decimal)]
    [InlineData(0xFE03, Key.RightAlt)]
    [InlineData(0xFFE4, Key.RightCtrl)]
    [InlineData(0xF6, Key.None)] // ö has no key of its own
    [InlineData(0xFE51, Key.None)] // neither has a dead accent
    public void A_symbol_means_its_key(int keysym, Key key) => Assert.Equal(key, Keysyms.KeyOf(keysym));

    [Theory]
    [InlineData(24, Key.Q)]
    [InlineData(38, Key.A)]
    [InlineData(54, Key.C)]
    [InlineData(58, Key.M)]
    [InlineData(37, Key.None)]
    public void Without_latin_letters_the_place_counts(uint keycode, Key key) => Assert.Equal(key, LatinKeys.KeyOf(keycode));

    [Fact]
    public void Locks_are_no_modifiers()
    {
        const uint capsNumShiftLeftButton = 2 | 16 | 1 | 256;

        Assert.Equal(RawInputModifiers.Shift | RawInputModifiers.LeftMouseButton, XModifiers.FromState(capsNumShiftLeftButton));
    }
}
