using Avalonia.Markup.Xaml;

namespace Engraver.App.Texts;

/// <summary>A text of the resources in XAML: <c>{t:Say Page.Layers}</c>.</summary>
public sealed class SayExtension(string name) : MarkupExtension
{
    public string Name { get; } = name;

    public override object ProvideValue(IServiceProvider serviceProvider) => Text.Get(Name);
}
