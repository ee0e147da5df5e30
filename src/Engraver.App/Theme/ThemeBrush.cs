using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;

namespace Engraver.App.Theme;

/// <summary>Sets the foreground by the name of a brush of the theme, so that a view model states a meaning instead of a colour, and the theme can
/// change.</summary>
public sealed class ThemeBrush
{
    public static readonly AttachedProperty<string?> ForegroundProperty = AvaloniaProperty.RegisterAttached<ThemeBrush, Control, string?>("Foreground");

    static ThemeBrush() => ForegroundProperty.Changed.AddClassHandler<Control>((control, _) => Apply(control));

    private ThemeBrush()
    {
    }

    public static string? GetForeground(Control control) => control.GetValue(ForegroundProperty);

    public static void SetForeground(Control control, string? key) => control.SetValue(ForegroundProperty, key);

    private static void Apply(Control control)
    {
        if (GetForeground(control) is not { } key) return;
        AvaloniaProperty property = control is TextBlock ? TextBlock.ForegroundProperty : TemplatedControl.ForegroundProperty;
        control[!property] = control.GetResourceObservable(key).ToBinding();
    }
}
