// The parts of the interface; each draws itself for one frame and changes what it is about.
#pragma once

#include <isocast/apps/viewer/window/app.h>

namespace isocast::viewer {

/// All of them, in their places, and the keys.
void draw_interface(App& app);

void draw_canvas(App& app);
void input_panel(App& app);
/// Of an animation its frame, else the time of formulas that know one: to drag, type and play.
void time_rows(App& app);
void objects_panel(App& app);
void iso_panel(App& app);
void method_panel(App& app);
void camera_panel(App& app);
void look_panel(App& app);
void clip_panel(App& app);
void color_panel(App& app);
void sureness_panel(App& app);
void output_panel(App& app);
void draw_probe(App& app);
void draw_status(App& app);
void draw_loading(App& app);

/// The histogram with a handle for each iso-value; returns whether one of them was moved.
bool iso_slider(App& app);
/// Errors against times of the methods.
void draw_points(App& app);
/// f along the ray of the probe.
void draw_profile(App& app, const PixelProbe& probe);

/// A text field that follows `source` until somebody types; `now`: takes every letter over. Returns whether
/// another text was taken over.
bool text_field(App& app, const char* name, TypedText& typed, const std::string& source, const char* hint,
                bool now = false);
/// A number that is typed and taken over with Enter or by leaving the field; returns whether it was.
bool number_field(App& app, const char* name, double& value, float width);
/// A choice of one of the names; returns whether another one was chosen.
bool choice(App& app, const char* name, const std::vector<std::string>& names, std::string& chosen);
/// A button that scripts can find.
bool button(App& app, const char* name, const char* label);
bool check_box(App& app, const char* name, const char* label, bool& value);
/// The rest of the width in a row, but for `reserved` times the size of text.
float rest_of_width(float reserved);
/// Text that is broken to the panel's width.
void wrapped(const std::string& text, bool warning = false);
/// On one line, with dots instead of what does not fit.
void shortened(std::string text, bool warning = false);

}  // namespace isocast::viewer
