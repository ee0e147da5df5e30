using Avalonia;
using Avalonia.Controls;
using Avalonia.Data.Converters;
using Avalonia.Media;

namespace Engraver.App.Theme;

/// <summary>A resource by a name that a view model gives.</summary>
public static class ResourceOf
{
    public static FuncValueConverter<string?, Geometry?> Geometry { get; } = new(key => key is not null && Application.Current!.TryFindResource(key, out var found) ? found as Geometry : null);
}
